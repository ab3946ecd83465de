#include <boost/math/tools/minima.hpp>

#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/algebra/period.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Cycles
{
  namespace
  {
    /// part of the samples that a period may be long
    const double longest_period = 1. / 12;

    /// minima of the relative mean square difference that are looked at
    const double      near_enough    = 0.05;
    const std::size_t most_tried     = 12;
    const double      surely_another = 0.1;

    /// times the difference of a multiple, below which the shorter is the
    /// period
    const double little_more = 2.;

    /// places at which a motion is compared with itself
    const std::size_t n_places = 2000;

    using Values = std::vector<double>;

    Values without_mean(Values values)
    {
      double mean = 0.;
      for (const double value : values)
        mean += value / values.size();
      for (double &value : values)
        value -= mean;
      return values;
    }

    /** sum_t x_t x_(t + tau) for all tau. */
    Values correlation(const Values &x)
    {
      std::size_t n = 1;
      while (n < 2 * x.size())
        n *= 2;
      Values padded = x;
      padded.resize(n, 0.);
      auto sums = Signals::fourier_sums(std::move(padded));
      for (auto &sum : sums)
        sum = std::norm(sum);
      return Signals::values_of_fourier_sums(std::move(sums), n);
    }

    /**
     * The mean square difference to the motion tau later over twice the mean
     * square, of all signals in their scales: 0 where they repeat themselves, 1
     * where they have nothing to do with it.
     */
    Values differences(const SampledMotion &motion,
                       const Values        &scales,
                       const std::size_t    n_lags)
    {
      const std::size_t n = motion.n_samples();
      Values            result(n_lags, 0.);
      double            square = 0.;
      for (std::size_t i = 0; i < scales.size(); ++i)
        {
          if (scales[i] == 0.)
            continue;
          const Values x       = without_mean(motion.signals[i].values);
          const Values product = correlation(x);
          const double one     = 1 / (scales[i] * scales[i]);
          square += one * product[0];
          double both = 2 * product[0]; // of the samples that have a partner
          for (std::size_t lag = 0; lag < n_lags; ++lag)
            {
              result[lag] += one * (both - 2 * product[lag]) / (n - lag);
              both -= x[lag] * x[lag] + x[n - 1 - lag] * x[n - 1 - lag];
            }
        }
      for (double &value : result)
        value *= square > 0. ? n / (2 * square) : 0.;
      return result;
    }

    /** Lags of the minima that come near, the shortest first. */
    std::vector<std::size_t> candidates(const Values &difference)
    {
      std::vector<std::size_t> lags;
      bool                     left = false; // the surroundings of lag 0
      for (std::size_t lag = 1; lag + 1 < difference.size(); ++lag)
        {
          const double here = difference[lag];
          left              = left || here > surely_another;
          if (left && here < near_enough && here <= difference[lag - 1] &&
              here < difference[lag + 1] && lags.size() < most_tried)
            lags.push_back(lag);
        }
      return lags;
    }

    /**
     * A motion against itself.
     */
    class Comparison
    {
    public:
      Comparison(const SampledMotion &motion, const Values &scales)
        : motion(motion)
        , scales(scales)
      {}

      /** The largest rms difference of a signal, at places that have no rhythm
       * of their own; or that of all together. */
      double difference(const double lag, const bool all) const
      {
        const std::size_t n = motion.n_samples();
        const auto        first =
          std::min(static_cast<std::size_t>(std::ceil(lag)) + 1, n - 1);
        const double golden = 0.6180339887498949;
        double       sum = 0., largest = 0.;
        for (std::size_t i = 0; i < scales.size(); ++i)
          {
            if (scales[i] == 0.)
              continue;
            const Values &x     = motion.signals[i].values;
            double        place = 0.5, squares = 0.;
            for (std::size_t k = 0; k < n_places; ++k)
              {
                place += golden;
                place -= std::floor(place);
                const auto t =
                  first + static_cast<std::size_t>(place * (n - first));
                const double off = x[t] - value_at(x, t - lag);
                squares += off * off;
              }
            const double mean = squares / n_places / (scales[i] * scales[i]);
            sum += mean;
            largest = std::max(largest, mean);
          }
        return all ? sum : std::sqrt(largest);
      }

      /**
       * The lag of n periods near @p lag at which the motion differs least from
       * itself.
       */
      double refined(const double lag, const double reach) const
      {
        const int bits = 20; // half of the digits: a minimum has no more
        return boost::math::tools::brent_find_minima(
                 [&](const double at) { return difference(at, true); },
                 lag - reach,
                 lag + reach,
                 bits)
          .first;
      }

    private:
      const SampledMotion &motion;
      const Values        &scales;
    };

    Period examined(const std::size_t lag,
                    const Comparison &comparison,
                    const std::size_t n_samples,
                    const double      tolerance)
    {
      Period period{comparison.refined(lag, 1.), 0.};
      period.difference = comparison.difference(period.length, false);
      if (period.difference > std::max(0.05, 20 * tolerance))
        return period;
      const double half = n_samples / 2.;
      for (double n = 2; n * period.length <= half; n *= 2)
        period.length =
          comparison.refined(n * period.length, std::min(1., n / 2)) / n;
      for (double n = 1; n * period.length <= half; n *= 2)
        period.difference =
          std::max(period.difference,
                   comparison.difference(n * period.length, false));
      const double most = std::floor(half / period.length);
      if (most > 1.)
        period.difference =
          std::max(period.difference,
                   comparison.difference(most * period.length, false));
      return period;
    }

    bool is_multiple(const Period &period, const Period &of)
    {
      const double ratio = period.length / of.length;
      return std::round(ratio) > 1. &&
             std::abs(ratio / std::round(ratio) - 1) < 0.01;
    }

    /** The period of least difference, or one that it is a multiple of and that
     * leaves little more. */
    Period shortest_of(const std::vector<Period> &periods)
    {
      const auto differs_less = [](const Period &a, const Period &b) {
        return a.difference < b.difference;
      };
      const auto best =
        std::min_element(periods.begin(), periods.end(), differs_less);
      if (best == periods.end())
        return {};
      for (const Period &shorter : periods)
        if (is_multiple(*best, shorter) &&
            shorter.difference < little_more * best->difference)
          return shorter;
      return *best;
    }
  } // namespace

  Period find_period(const SampledMotion &motion,
                     const Values        &scales,
                     const double         tolerance)
  {
    const std::size_t n      = motion.n_samples();
    const auto        n_lags = static_cast<std::size_t>(longest_period * n);
    if (n_lags < 4)
      return {};
    const Comparison    comparison(motion, scales);
    std::vector<Period> periods;
    for (const std::size_t lag :
         candidates(differences(motion, scales, n_lags)))
      {
        periods.push_back(examined(lag, comparison, n, tolerance));
        if (periods.back().difference <= tolerance)
          break;
      }
    return shortest_of(periods);
  }
} // namespace RollingContact::Cycles
