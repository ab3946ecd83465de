#include <rolling_contact/plot/plot_axis.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    std::string
    fixed(const double value, const int decimals)
    {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text.precision(decimals);
      text << std::fixed << value + 0.;
      return text.str();
    }
  } // namespace



  PlotAxis::PlotAxis(const AxisScale scale, const std::vector<double> &values)
    : scale(scale)
    , lower(0.)
    , upper(1.)
    , pixel_begin(0.)
    , pixel_end(1.)
  {
    if (!values.empty())
      {
        const auto range = std::minmax_element(values.begin(), values.end());
        lower = is_logarithmic() ? std::log10(*range.first) : *range.first;
        upper = is_logarithmic() ? std::log10(*range.second) : *range.second;
      }

    const double magnitude = std::max(std::abs(lower), std::abs(upper));
    double       margin    = 0.04 * (upper - lower);
    if (upper - lower <= std::max(1e-12 * magnitude, 1e-290))
      margin =
        is_logarithmic() ? 0.3 : (magnitude > 1e-290 ? 0.1 * magnitude : 1.);
    lower -= margin;
    upper += margin;
  }



  bool
  PlotAxis::is_logarithmic() const
  {
    return scale == AxisScale::logarithmic;
  }



  void
  PlotAxis::set_pixels(const double begin, const double end)
  {
    pixel_begin = begin;
    pixel_end   = end;
  }



  double
  PlotAxis::position(const double value) const
  {
    const double coordinate = is_logarithmic() ? std::log10(value) : value;
    return pixel_begin +
           (coordinate - lower) / (upper - lower) * (pixel_end - pixel_begin);
  }



  double
  PlotAxis::clamped_position(const double value) const
  {
    if (is_logarithmic() && value <= 0.)
      return pixel_begin;
    const auto range = std::minmax(pixel_begin, pixel_end);
    return std::clamp(position(value), range.first, range.second);
  }



  int
  PlotAxis::exponent() const
  {
    if (is_logarithmic())
      return 0;
    const double magnitude = std::max(std::abs(lower), std::abs(upper));
    const int    power     = std::floor(std::log10(magnitude));
    return power >= 5 || power <= -3 ? 3 * std::floor(power / 3.) : 0;
  }



  std::vector<PlotTick>
  PlotAxis::ticks(const unsigned int n_wanted) const
  {
    if (!is_logarithmic())
      return linear_ticks(lower, upper, exponent(), n_wanted);

    const std::vector<PlotTick> ticks = logarithmic_ticks(n_wanted);
    const auto                  n_major =
      std::count_if(ticks.begin(), ticks.end(), [](const PlotTick &tick) {
        return tick.is_major;
      });
    return n_major >= 2 ? ticks
                        : linear_ticks(std::pow(10., lower),
                                       std::pow(10., upper),
                                       0,
                                       n_wanted);
  }



  /** Multiples of 1, 2 or 5 times a power of ten. */
  std::vector<PlotTick>
  PlotAxis::linear_ticks(const double       first,
                         const double       last,
                         const int          power,
                         const unsigned int n_wanted) const
  {
    const double raw_step = (last - first) / n_wanted;
    const double unit     = std::pow(10., std::floor(std::log10(raw_step)));
    const double ratio    = raw_step / unit;
    const double multiple =
      ratio < 1.5 ? 1. : (ratio < 3.5 ? 2. : (ratio < 7.5 ? 5. : 10.));
    const double step         = multiple * unit;
    const int    step_decade  = std::floor(std::log10(step) + 1e-9);
    const int    n_decimals   = std::max(0, power - step_decade);
    const double first_number = std::ceil(first / step - 1e-6);

    std::vector<PlotTick> ticks;
    for (double i = first_number; i <= last / step + 1e-6; ++i)
      ticks.push_back(
        {i * step,
         with_minus_sign(fixed(i * step / std::pow(10., power), n_decimals)),
         true});
    return ticks;
  }



  /** Decades, with labels at 2 and 5 if there are few, and minor ticks. */
  std::vector<PlotTick>
  PlotAxis::logarithmic_ticks(const unsigned int n_wanted) const
  {
    const double n_decades = upper - lower;
    const int    stride =
      std::max(1, static_cast<int>(std::ceil(n_decades / n_wanted)));

    std::vector<PlotTick> ticks;
    for (int power = std::floor(lower); power <= upper; ++power)
      for (const int multiple : {1, 2, 3, 4, 5, 6, 7, 8, 9})
        {
          const double logarithm = power + std::log10(multiple);
          if (logarithm < lower || logarithm > upper)
            continue;
          const bool is_decade = multiple == 1 && power % stride == 0;
          const bool is_major =
            is_decade || (n_decades < 2. &&
                          (multiple == 1 || multiple == 2 || multiple == 5));
          if (is_major || stride == 1)
            ticks.push_back(
              {std::pow(10., logarithm),
               is_major ? logarithmic_label(multiple, power) : PlotText(),
               is_major});
        }
    return ticks;
  }



  PlotText
  PlotAxis::logarithmic_label(const int multiple, const int power) const
  {
    const bool is_plain = lower > -2.5 && upper < 3.5;
    if (is_plain)
      return plain_text(
        fixed(multiple * std::pow(10., power), std::max(0, -power)));
    return power_of_ten(multiple == 1 ? ""
                                      : std::to_string(multiple) + "\u00D7",
                        power);
  }
} // namespace RollingContact
