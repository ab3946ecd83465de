#ifndef rolling_contact_plot_svg_plot_h
#define rolling_contact_plot_svg_plot_h

#include <rolling_contact/run/run_folder.h>

#include <string>
#include <vector>

namespace RollingContact
{
  enum class CurveStyle
  {
    line,
    dashed,
    points,
    line_and_points,
    /** Black, each dashed in its way; takes no colour of the palette. */
    reference
  };

  enum class AxisScale
  {
    linear,
    logarithmic
  };

  /**
   * A plot of curves y(x) as an SVG file, ready for a paper. Ranges and ticks
   * follow from the data; the legend takes an empty corner, or the right side
   * if there is none. Points that are not finite, or not positive on a
   * logarithmic axis, leave a gap. Texts are UTF-8.
   */
  class SvgPlot
  {
  public:
    /** Labels carry their units. */
    SvgPlot(const std::string &title,
            const std::string &x_label,
            const std::string &y_label);

    void
    set_scales(const AxisScale x_scale, const AxisScale y_scale);

    /** A curve without label is not in the legend. */
    void
    add_curve(const std::string         &label,
              const std::vector<double> &x,
              const std::vector<double> &y,
              const CurveStyle           style = CurveStyle::line);

    /** Shades begin <= x <= end behind the curves. */
    void
    add_band(const std::string &label, const double begin, const double end);

    std::string
    svg() const;

    void
    write(RunFolder &folder, const std::string &file_name) const;

    struct Curve
    {
      std::string         label;
      std::vector<double> x;
      std::vector<double> y;
      CurveStyle          style;
    };

    struct Band
    {
      std::string label;
      double      begin;
      double      end;
    };

    /** What is to be drawn, without any layout. */
    struct Content
    {
      std::string        title;
      std::string        x_label;
      std::string        y_label;
      AxisScale          x_scale = AxisScale::linear;
      AxisScale          y_scale = AxisScale::linear;
      std::vector<Curve> curves  = {};
      std::vector<Band>  bands   = {};
    };

  private:
    Content content;
  };
} // namespace RollingContact

#endif
