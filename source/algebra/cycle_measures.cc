#include <rolling_contact/algebra/cycle_measures.h>
#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/base/constants.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Cycles
{
  namespace
  {
    const std::size_t most_periods = 16;
  } // namespace

  WholePeriods::WholePeriods(const double      period,
                             const std::size_t n_samples,
                             const std::size_t n_judged)
    : period(period)
    , n_samples(n_samples)
    , n_periods(std::clamp<std::size_t>(static_cast<std::size_t>(
                                          (n_judged - 1) / period),
                                        1,
                                        most_periods))
    , begin(std::max(0., n_samples - 1 - n_periods * period))
  {}

  std::size_t WholePeriods::first_sample() const
  {
    return static_cast<std::size_t>(std::ceil(begin));
  }

  double WholePeriods::mean(const std::vector<double> &values) const
  {
    const std::size_t first = first_sample();
    const double      part  = first - begin; // of a step, before the first
    double            sum   = 0.;
    for (std::size_t t = first; t + 1 < n_samples; ++t)
      sum += (values[t] + values[t + 1]) / 2;
    if (part > 0.)
      {
        const double at_begin =
          values[first] + part * (values[first - 1] - values[first]);
        sum += part * (at_begin + values[first]) / 2;
      }
    return sum / (n_samples - 1 - begin);
  }

  double WholePeriods::rms(const std::vector<double> &values) const
  {
    const double        middle = mean(values);
    std::vector<double> squares(values.size());
    for (std::size_t t = 0; t < values.size(); ++t)
      squares[t] = (values[t] - middle) * (values[t] - middle);
    return std::sqrt(mean(squares));
  }

  double WholePeriods::least(const std::vector<double> &values) const
  {
    return *std::min_element(values.begin() + first_sample(), values.end());
  }

  double WholePeriods::most(const std::vector<double> &values) const
  {
    return *std::max_element(values.begin() + first_sample(), values.end());
  }

  double WholePeriods::change(const std::vector<double> &sums) const
  {
    const std::size_t first = first_sample();
    const double      part  = first - begin,
                 at_begin   = part > 0. ? sums[first] +
                                          part * (sums[first - 1] - sums[first])
                                        : sums[first];
    return (sums.back() - at_begin) / n_periods;
  }

  std::vector<double> WholePeriods::harmonics(const std::vector<double> &values,
                                              const std::size_t n) const
  {
    std::size_t number = 0;
    while (number < n && 2.5 * (number + 1) < period)
      ++number;
    const std::size_t first = first_sample();
    DenseMatrix shapes = DenseMatrix::Zero(n_samples - first, 1 + 2 * number);
    for (std::size_t t = first; t < n_samples; ++t)
      {
        shapes(t - first, 0) = 1.;
        for (std::size_t k = 1; k <= number; ++k)
          {
            const double angle           = 2 * pi * k * (t - begin) / period;
            shapes(t - first, 2 * k - 1) = std::cos(angle);
            shapes(t - first, 2 * k)     = std::sin(angle);
          }
      }
    std::vector<double> fitted(values.begin() + first, values.end());
    std::vector<double> amplitudes(number, 0.);
    if (!solve_least_squares(shapes, fitted))
      return {};
    for (std::size_t k = 1; k <= number; ++k)
      amplitudes[k - 1] = std::hypot(fitted[2 * k - 1], fitted[2 * k]);
    return amplitudes;
  }
} // namespace RollingContact::Cycles
