#ifndef rolling_contact_plot_plot_axis_h
#define rolling_contact_plot_plot_axis_h

#include <rolling_contact/plot/svg_canvas.h>
#include <rolling_contact/plot/svg_plot.h>

#include <vector>

namespace RollingContact
{
  struct PlotTick
  {
    double   value;
    PlotText label;
    bool     is_major;
  };

  /**
   * Range, ticks and pixels of one axis. A logarithmic axis holds its range
   * as decimal logarithms.
   */
  class PlotAxis
  {
  public:
    PlotAxis(const AxisScale scale, const std::vector<double> &values);

    void
    set_pixels(const double begin, const double end);
    double
    position(const double value) const;
    double
    clamped_position(const double value) const;
    std::vector<PlotTick>
    ticks(const unsigned int n_wanted) const;

    /** The power of ten all labels are to be multiplied with. */
    int
    exponent() const;

  private:
    bool
    is_logarithmic() const;
    std::vector<PlotTick>
    linear_ticks(const double       first,
                 const double       last,
                 const int          power,
                 const unsigned int n_wanted) const;
    std::vector<PlotTick>
    logarithmic_ticks(const unsigned int n_wanted) const;
    PlotText
    logarithmic_label(const int multiple, const int power) const;

    const AxisScale scale;
    double          lower;
    double          upper;
    double          pixel_begin;
    double          pixel_end;
  };
} // namespace RollingContact

#endif
