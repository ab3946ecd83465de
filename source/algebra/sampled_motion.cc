#include <rolling_contact/algebra/sampled_motion.h>

#include <algorithm>
#include <map>

namespace RollingContact::Cycles
{
  namespace
  {
    /// of the largest range of its kind: what is less is measured by this
    const double least_share = 1e-3;
  } // namespace

  SampledMotion SampledMotion::part(const std::size_t first,
                                    const std::size_t end) const
  {
    SampledMotion result{step, {}};
    for (const Signal &signal : signals)
      result.signals.push_back(
        {{signal.values.begin() + first, signal.values.begin() + end},
         signal.kind,
         signal.floor});
    return result;
  }

  double range_of(const std::vector<double> &values)
  {
    if (values.empty())
      return 0.;
    const auto [least, most] =
      std::minmax_element(values.begin(), values.end());
    return *most - *least;
  }

  std::vector<double> scales_of(const SampledMotion &motion)
  {
    std::map<unsigned int, double> largest;
    std::vector<double>            scales;
    for (const Signal &signal : motion.signals)
      {
        scales.push_back(range_of(signal.values));
        double &of_kind = largest[signal.kind];
        if (scales.back() > signal.floor)
          of_kind = std::max(of_kind, scales.back());
      }
    for (std::size_t i = 0; i < scales.size(); ++i)
      {
        const double of_kind = largest[motion.signals[i].kind];
        scales[i] =
          of_kind > 0. ? std::max(scales[i], least_share * of_kind) : 0.;
      }
    return scales;
  }

  double value_at(const std::vector<double> &values, const double place)
  {
    const std::size_t n = values.size();
    if (n < 4)
      return values[static_cast<std::size_t>(place)];
    const auto        below = static_cast<std::size_t>(std::max(0., place));
    const std::size_t first = std::min(below < 1 ? 0 : below - 1, n - 4);
    const double      x     = place - first;
    const double     *v     = values.data() + first;
    return -(x - 1) * (x - 2) * (x - 3) / 6 * v[0] +
           x * (x - 2) * (x - 3) / 2 * v[1] - x * (x - 1) * (x - 3) / 2 * v[2] +
           x * (x - 1) * (x - 2) / 6 * v[3];
  }
} // namespace RollingContact::Cycles
