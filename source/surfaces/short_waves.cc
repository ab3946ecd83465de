#include <rolling_contact/algebra/welch.h>
#include <rolling_contact/surfaces/short_waves.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace RollingContact
{
  namespace
  {
    const unsigned int per_element = 4, n_stretches = 128;
    const std::size_t  longest_stretch = 256 * per_element,
                      shortest_stretch = 16 * per_element;

    /** Add what a stretch of samples has. */
    void examine(const std::vector<double> &samples, ShortWaves &found)
    {
      const std::size_t n     = samples.size();
      const auto        lines = Signals::segment_amplitudes(samples, n).front();
      double            all = 0., two = 0., four = 0.;
      for (std::size_t k = 1; k < lines.size(); ++k)
        {
          const double power = std::norm(lines[k]);
          // waves per element; the window spreads a wave over its neighbours
          const double waves = (k - 2.) / n * per_element;
          all += power;
          four += waves > 0.25 ? power : 0.;
          two += waves > 0.5 ? power : 0.;
        }
      found.rms        = std::max(found.rms, std::sqrt(all));
      found.below_two  = std::max(found.below_two, std::sqrt(two));
      found.below_four = std::max(found.below_four, std::sqrt(four));
    }
  } // namespace

  ShortWaves short_waves(const std::function<double(const double)> &height,
                         const double                               begin,
                         const double                               end,
                         const double                               element)
  {
    const double      step = element / per_element;
    const std::size_t n    = std::clamp<double>(std::ceil((end - begin) / step),
                                             shortest_stretch,
                                             longest_stretch);
    const double      length = n * step,
                 start       = std::min(begin, (begin + end - length) / 2);
    const auto n_needed      = static_cast<unsigned int>(
      std::min<double>(n_stretches, std::ceil((end - start) / length)));
    const unsigned int n_taken = std::max(1u, n_needed);
    ShortWaves         found;
    for (unsigned int part = 0; part < n_taken; ++part)
      {
        const double from =
          n_taken == 1 ? start
                       : start + part * (end - length - start) / (n_taken - 1);
        std::vector<double> samples;
        for (std::size_t j = 0; j < n; ++j)
          {
            samples.push_back(height(from + j * step));
            found.highest = std::max(found.highest, std::abs(samples.back()));
            const double slope =
              j == 0 ? 0. : std::abs(samples[j] - samples[j - 1]) / step;
            if (slope > found.steepest)
              {
                found.steepest      = slope;
                found.steepest_from = from + (j - 1) * step;
              }
          }
        examine(samples, found);
      }
    return found;
  }
} // namespace RollingContact
