#ifndef rolling_contact_plot_svg_canvas_h
#define rolling_contact_plot_svg_canvas_h

#include <sstream>
#include <string>
#include <vector>

namespace RollingContact
{
  /** Pixels; y points down. */
  struct PlotPoint
  {
    double x;
    double y;
  };

  struct PlotBox
  {
    double left;
    double top;
    double right;
    double bottom;

    bool
    contains(const PlotPoint &point) const
    {
      return point.x >= left && point.x <= right && point.y >= top &&
             point.y <= bottom;
    }
  };

  /** SVG text, already escaped, and about how wide it is at font size 1. */
  struct PlotText
  {
    std::string markup;
    double      width;
  };

  /** A coordinate as text: two decimals, no trailing zeros. */
  std::string
  pixels(const double value);

  PlotText
  plain_text(const std::string &text);

  PlotText
  with_minus_sign(const std::string &number);

  /** factor times 10^exponent; a factor of 1 is not shown. */
  PlotText
  power_of_ten(const std::string &factor, const int exponent);

  /** Writes shapes and texts as elements of an SVG file. */
  class SvgCanvas
  {
  public:
    enum class Anchor
    {
      start,
      middle,
      end
    };

    SvgCanvas(const double       width,
              const double       height,
              const PlotText    &title,
              const std::string &text_colour);

    void
    rectangle(const PlotBox &box, const std::string &attributes);
    void
    line(const PlotPoint   &from,
         const PlotPoint   &to,
         const std::string &attributes);

    /** Leaves out points that nearly coincide. */
    void
    polyline(const std::vector<PlotPoint> &points,
             const std::string            &attributes);
    void
    polygon(const std::vector<PlotPoint> &points,
            const std::string            &attributes);
    void
    circle(const PlotPoint   &centre,
           const double       radius,
           const std::string &attributes);
    void
    text(const PlotText    &text,
         const PlotPoint   &point,
         const double       font,
         const Anchor       anchor,
         const std::string &attributes = "");

    /** The file so far, complete. */
    std::string
    svg() const;

  private:
    std::ostringstream out;
  };
} // namespace RollingContact

#endif
