#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/algebra/third_octaves.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/time/sound_pressure.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Sound
{
  double mean_square_pressure(const double power,
                              const Air   &air,
                              const double distance)
  {
    return air.density * air.speed * power / (2 * pi * distance * distance);
  }

  double power_level(const double power)
  {
    return 10 * std::log10(power / 1e-12);
  }

  double pressure_level(const double mean_square)
  {
    return Signals::level(mean_square, 20e-6);
  }

  std::size_t steps_of_whole_samples(const std::size_t  n,
                                     const double       time_step,
                                     const unsigned int rate)
  {
    std::size_t best = n;
    double      left = 1.;
    for (std::size_t m = n; m + n / 100 >= n && m > 0; --m)
      {
        const double samples = m * time_step * rate,
                     off     = std::abs(samples - std::round(samples));
        if (off < left - 1e-9)
          {
            best = m;
            left = off;
          }
      }
    return best;
  }

  std::vector<double> pressure_over_time(const std::vector<BodySound> &sounds,
                                         const double                  duration,
                                         const Air                    &air,
                                         const double                  distance,
                                         const unsigned int            rate)
  {
    const std::size_t n = std::max<long long>(std::llround(duration * rate), 1);
    std::vector<std::complex<double>> sums(n / 2 + 1, 0.);
    for (std::size_t k = 1; 2 * k < n; ++k)
      {
        double               power  = 0.;
        std::complex<double> signal = 0.;
        for (const BodySound &sound : sounds)
          if (k < sound.line_powers.size())
            {
              power += sound.line_powers[k];
              signal += sound.line_signals[k];
            }
        const double size        = std::abs(signal);
        const double mean_square = mean_square_pressure(power, air, distance);
        sums[k] = std::sqrt(mean_square / 2) * static_cast<double>(n) *
                  (size > 0. ? signal / size : 1.);
      }
    return Signals::values_of_fourier_sums(std::move(sums), n);
  }

  std::vector<double> repeated_periods(const std::vector<double> &record,
                                       const double               period,
                                       const std::size_t          n_samples)
  {
    const std::size_t end  = record.size() - record.size() / 10;
    const double      most = std::floor(end / (2 * period));
    if (!(most >= 10.) || record.size() >= n_samples)
      return record;
    double length = 0., least = 1.;
    for (double n = std::ceil(most / 2); n <= most; ++n)
      {
        const double whole = std::round(n * period),
                     rest  = std::abs(n * period - whole) / n;
        if (whole <= end && rest < least)
          {
            least  = rest;
            length = whole;
          }
      }
    const std::size_t   loop = length;
    std::vector<double> samples(n_samples);
    for (std::size_t i = 0; i < n_samples; ++i)
      samples[i] = record[end - loop + i % loop];
    return samples;
  }
} // namespace RollingContact::Sound
