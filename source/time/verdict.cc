#include <rolling_contact/base/text.h>
#include <rolling_contact/time/verdict.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Cycles
{
  namespace
  {
    const std::size_t least_judged   = 100; ///< samples
    const double      steady_enough  = 0.05;
    const std::size_t first_verdict  = 400;
    const std::size_t part_until_due = 32;

    double left_over(const SampledMotion &motion, const SampledMotion &end)
    {
      double     largest = 0.;
      const auto scales  = scales_of(motion);
      for (std::size_t i = 0; i < scales.size(); ++i)
        if (scales[i] > 0.)
          largest =
            std::max(largest, range_of(end.signals[i].values) / scales[i]);
      return largest;
    }

    bool is_at_rest(const std::vector<double> &scales)
    {
      return std::all_of(scales.begin(), scales.end(), [](const double scale) {
        return scale == 0.;
      });
    }

    /** Whether what is below all floors grows nevertheless. */
    bool grows_from_nothing(const SampledMotion &end)
    {
      std::vector<double> ranges;
      for (const Signal &signal : end.signals)
        ranges.push_back(range_of(signal.values));
      const AmplitudeTrend trend = amplitude_trend(end, ranges, 0.);
      return trend.changes && trend.rate > 0.;
    }

    /** x(t) - x(t - m T), with m T of about a quarter of the samples. */
    SampledMotion differences_of(const SampledMotion &motion,
                                 const double         period)
    {
      const std::size_t n = motion.n_samples();
      const double  lag   = std::max(1., std::floor(n / 4. / period)) * period;
      const auto    first = static_cast<std::size_t>(std::ceil(lag)) + 1;
      SampledMotion result{motion.step, {}};
      for (const Signal &signal : motion.signals)
        {
          Signal difference{{}, signal.kind, signal.floor};
          for (std::size_t t = first; t < n; ++t)
            difference.values.push_back(signal.values[t] -
                                        value_at(signal.values, t - lag));
          result.signals.push_back(std::move(difference));
        }
      return result;
    }

    bool goes_on_to_grow(const AmplitudeTrend &trend)
    {
      return trend.changes && trend.rate > 0. && !trend.settles();
    }

    bool repeats_itself(const Verdict &verdict, const double tolerance)
    {
      return verdict.period.length > 0. &&
             verdict.period.difference <= tolerance &&
             verdict.amplitude.spread <= tolerance &&
             verdict.amplitude.settles() &&
             !goes_on_to_grow(verdict.differences);
    }
  } // namespace

  Verdict judge(const SampledMotion &motion,
                const std::size_t    first,
                const double         tolerance)
  {
    Verdict           verdict;
    const std::size_t n     = motion.n_samples();
    const std::size_t after = n > first ? n - first : 0;
    verdict.step            = motion.step;
    verdict.n_judged        = after / 4;
    if (verdict.n_judged < least_judged)
      return verdict;
    const SampledMotion       end    = motion.part(n - verdict.n_judged, n);
    const std::vector<double> scales = scales_of(end);
    verdict.left_over                = left_over(motion, end);
    verdict.motion                   = Motion::decayed;
    if (is_at_rest(scales))
      {
        if (grows_from_nothing(end))
          verdict.motion = Motion::changing;
        return verdict;
      }
    verdict.period    = find_period(end, scales, tolerance);
    verdict.amplitude = amplitude_trend(end, scales, verdict.period.length);
    if (verdict.period.length > 0.)
      verdict.differences =
        amplitude_trend(differences_of(end, verdict.period.length),
                        scales,
                        verdict.period.length);
    const AmplitudeTrend &trend = verdict.amplitude;
    if (repeats_itself(verdict, tolerance))
      verdict.motion = Motion::periodic;
    else if (!(verdict.left_over <= tolerance && trend.changes &&
               trend.rate < 0.))
      {
        const bool steady = trend.settles() && trend.spread <= steady_enough,
                   grows  = verdict.period.difference <= tolerance &&
                           goes_on_to_grow(verdict.differences);
        verdict.motion =
          steady && !grows ? Motion::stationary : Motion::changing;
      }
    return verdict;
  }

  std::string name_of(const Motion motion)
  {
    switch (motion)
      {
        case Motion::periodic:
          return "periodic";
        case Motion::stationary:
          return "stationary";
        case Motion::decayed:
          return "decayed";
        case Motion::changing:
          return "changing";
        default:
          return "too short";
      }
  }

  std::string sentence(const Verdict &verdict)
  {
    const AmplitudeTrend &trend  = verdict.amplitude;
    const std::string     change = "its amplitude changes by " +
                               significant(trend.rate, 2) + " +- " +
                               significant(trend.uncertainty, 1) + " 1/s";
    switch (verdict.motion)
      {
        case Motion::periodic:
          return "periodic, " + significant(verdict.frequency(), 6) +
                 " Hz; periods differ by " +
                 scientific(verdict.period.difference, 2) + " of the ranges, " +
                 change + ", " + scientific(trend.remaining, 1) +
                 " of it is still to come";
        case Motion::stationary:
          return "stationary but not periodic: levels stay within " +
                 significant(100 * trend.spread, 2) + " %, " + change +
                 (verdict.period.length > 0.
                    ? ", and the nearest period, " +
                        significant(verdict.frequency(), 5) + " Hz, leaves " +
                        scientific(verdict.period.difference, 2) +
                        " of the ranges"
                    : ", and there is no period");
        case Motion::decayed:
          if (verdict.left_over == 0.)
            return "decayed to the steady state: nothing moves";
          return "decayed to the steady state, to " +
                 scientific(verdict.left_over, 1) + " of the largest ranges";
        case Motion::changing:
          if (verdict.left_over == 0.)
            return "still grows at the end, and is tiny yet";
          return "still changes at the end: " + change +
                 (goes_on_to_grow(verdict.differences)
                    ? ", and the difference from period to period, " +
                        scientific(verdict.period.difference, 2) +
                        " of the ranges, grows by " +
                        significant(verdict.differences.rate, 2) + " 1/s"
                    : "");
        default:
          return "too short to tell whether it is periodic";
      }
  }

  bool is_due(const std::size_t n_samples)
  {
    std::size_t due = first_verdict;
    while (due < n_samples)
      due += std::max<std::size_t>(first_verdict / 4, due / part_until_due);
    return due == n_samples;
  }
} // namespace RollingContact::Cycles
