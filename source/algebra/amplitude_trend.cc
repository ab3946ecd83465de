#include <rolling_contact/algebra/amplitude_trend.h>
#include <rolling_contact/base/constants.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace RollingContact::Cycles
{
  namespace
  {
    constexpr std::size_t n_stretches = 8;
    using Levels                      = std::array<double, n_stretches>;

    /// of all samples: neighbours overlap by half
    const double part_of_stretch = 2. / (n_stretches + 1);

    /// relative changes that are still of the samples, which have 9 digits
    const double still = 1e-7;

    const double certain = 4.; ///< standard errors

    /// level over the mean that is as good as none
    const double nothing = 1e-12;

    /** The mean square about the mean with weights 1 - cos, from @p begin on.
     */
    double variance(const std::vector<double> &x,
                    const double               begin,
                    const double               length)
    {
      double     weights = 0., sum = 0., squares = 0.;
      const auto last = static_cast<std::size_t>(
        std::min(std::floor(begin + length), x.size() - 1.));
      const double near = x[static_cast<std::size_t>(std::ceil(begin))];
      for (auto t = static_cast<std::size_t>(std::ceil(begin)); t <= last; ++t)
        {
          const double weight = 1 - std::cos(2 * pi * (t - begin) / length),
                       value  = x[t] - near; // without digits of the mean
          weights += weight;
          sum += weight * value;
          squares += weight * value * value;
        }
      const double mean = sum / weights;
      return std::max(0., squares / weights - mean * mean);
    }

    struct Line
    {
      double slope, error; ///< per stretch, and its standard error
    };

    Line line_through(const double *levels, const std::size_t n)
    {
      double mean = 0., slope = 0., squares = 0., residual = 0.;
      for (std::size_t k = 0; k < n; ++k)
        mean += levels[k] / n;
      const double centre = (n - 1) / 2.;
      for (std::size_t k = 0; k < n; ++k)
        {
          slope += (k - centre) * levels[k];
          squares += (k - centre) * (k - centre);
        }
      slope /= squares;
      for (std::size_t k = 0; k < n; ++k)
        residual += std::pow(levels[k] - mean - slope * (k - centre), 2);
      return {slope, std::sqrt(residual / (n - 2) / squares)};
    }
  } // namespace

  AmplitudeTrend amplitude_trend(const SampledMotion       &motion,
                                 const std::vector<double> &scales,
                                 const double               period)
  {
    const double all    = motion.n_samples() - 1.;
    double       length = part_of_stretch * all;
    if (period > 0.)
      length = std::max(1., std::floor(length / period)) * period;
    const double distance = (all - length) / (n_stretches - 1);
    Levels       levels{};
    for (std::size_t k = 0; k < n_stretches; ++k)
      {
        for (std::size_t i = 0; i < scales.size(); ++i)
          if (scales[i] > 0.)
            levels[k] +=
              variance(motion.signals[i].values, k * distance, length) /
              (scales[i] * scales[i]);
        levels[k] = std::sqrt(levels[k]);
      }
    AmplitudeTrend trend;
    for (const double level : levels)
      trend.mean += level / n_stretches;
    if (!(trend.mean > 0.))
      return trend;
    for (double &level : levels)
      level = std::max(level / trend.mean, nothing);
    const auto [least, most] =
      std::minmax_element(levels.begin(), levels.end());
    trend.spread = *most - *least;

    for (double &level : levels) // an exponential becomes a straight line
      level = std::log(level);

    const std::size_t half   = n_stretches / 2;
    const Line        line   = line_through(levels.data(), n_stretches);
    const double      before = line_through(levels.data(), half).slope,
                 after       = line_through(levels.data() + half, half).slope;
    trend.rate               = line.slope / (distance * motion.step);
    trend.uncertainty        = 2 * line.error / (distance * motion.step);
    trend.changes =
      std::abs(line.slope) > certain * line.error && trend.spread > still;
    trend.ratio =
      before != 0. ? after / before : std::numeric_limits<double>::infinity();
    trend.remaining = trend.spread;
    if (trend.changes && trend.ratio >= 1.)
      trend.remaining = std::numeric_limits<double>::infinity();
    else if (trend.changes && trend.ratio >= 0.)
      trend.remaining =
        std::abs(after) * half * trend.ratio / (1 - trend.ratio);
    return trend;
  }
} // namespace RollingContact::Cycles
