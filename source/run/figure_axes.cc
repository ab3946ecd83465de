#include <fmt/format.h>

#include <rolling_contact/base/text.h>
#include <rolling_contact/run/figure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace RollingContact
{
  bool Figure::can_be_drawn(const double value, const AxisScale scale)
  {
    return std::abs(value) < 1e300 &&
           (scale == AxisScale::linear || value > 1e-300);
  }

  /**
   * Ranges that hold all curves with units of equal length in both directions,
   * in the first panel, which is of this size.
   */
  std::string Figure::equal_ranges(const std::array<double, 2> &pixels) const
  {
    const double          far = std::numeric_limits<double>::max();
    std::array<double, 2> lower{{far, far}}, upper{{-far, -far}};
    for (const Curve &curve : curves)
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        for (const unsigned int d : {0, 1})
          {
            const double value = d == 0 ? curve.x[i] : curve.y[i];
            if (!can_be_drawn(value, AxisScale::linear))
              continue;
            lower[d] = std::min(lower[d], value);
            upper[d] = std::max(upper[d], value);
          }
    const double margin = 1.08;
    double       unit   = 0.; // for a pixel
    for (const unsigned int d : {0, 1})
      unit = std::max(unit, margin * (upper[d] - lower[d]) / pixels[d]);
    if (!(unit > 0.) || !(unit < far))
      return "";
    std::string text;
    for (const unsigned int d : {0, 1})
      {
        const double middle = (lower[d] + upper[d]) / 2,
                     half   = unit * pixels[d] / 2;
        text += fmt::format("set {}range [{}:{}]\n",
                            d == 0 ? 'x' : 'y',
                            significant(middle - half, 9),
                            significant(middle + half, 9));
      }
    return text;
  }

  std::string Figure::axis(const char axis, const std::string &label) const
  {
    const AxisScale scale = axis == 'x' ? x_scale : y_scale;
    double          lower = std::numeric_limits<double>::max(), upper = 0.;
    bool            is_empty = maps.empty();
    for (const Curve &curve : curves)
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (can_be_drawn(curve.x[i], x_scale) &&
            can_be_drawn(curve.y[i], y_scale))
          {
            const double value = axis == 'x' ? curve.x[i] : curve.y[i];
            is_empty           = false;
            lower              = std::min(lower, value);
            upper              = std::max(upper, value);
          }

    std::string text =
      fmt::format("set {}label {} noenhanced\n", axis, quoted(label));
    if (is_empty)
      return text + fmt::format("set {}range [1:10]\n", axis);
    if (scale == AxisScale::linear)
      return text;
    text += fmt::format("set logscale {0}\nset m{0}tics 10\n", axis);
    const bool        is_plain = lower > 3e-3 && upper < 3e4;
    const std::string decade   = is_plain ? "%g" : "10^{%T}",
                      other    = is_plain ? "%g" : "%.0t\u00D710^{%T}";
    text += fmt::format("set format {} \"{}\"\n", axis, decade);
    if (upper < 100. * lower)
      text += fmt::format("set for [p={0}:{1}] for [m=2:5:3] {2}tics add "
                          "(gprintf(\"{3}\", m * 10.**p) m * 10.**p)\n",
                          std::floor(std::log10(lower)),
                          std::floor(std::log10(upper)),
                          axis,
                          other);
    return text;
  }
} // namespace RollingContact
