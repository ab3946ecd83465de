#include <rolling_contact/algebra/fourier.h>
#include <rolling_contact/algebra/low_pass.h>
#include <rolling_contact/base/constants.h>

#include <cmath>

namespace RollingContact::Signals
{
  double CutOff::gain(const double wave_number) const
  {
    const double passes = 1 / passed;
    if (wave_number <= passes * (1 + 1e-12))
      return 1.;
    if (stopped > 0. && wave_number >= 1 / stopped * (1 - 1e-12))
      return 0.;
    if (stopped <= 0.)
      return 1.;
    return (1 +
            std::cos(pi * (wave_number - passes) / (1 / stopped - passes))) /
           2;
  }

  std::vector<double> low_pass_periodic(const std::vector<double> &values,
                                        const double               spacing,
                                        const CutOff              &cut_off)
  {
    const double length = spacing * static_cast<double>(values.size());
    auto         sums   = fourier_sums(values);
    for (std::size_t k = 0; k < sums.size(); ++k)
      sums[k] *= cut_off.gain(static_cast<double>(k) / length);
    return values_of_fourier_sums(std::move(sums), values.size());
  }

  std::vector<double> low_pass_mirrored(const std::vector<double> &values,
                                        const double               spacing,
                                        const CutOff              &cut_off)
  {
    const double length = 2 * spacing * static_cast<double>(values.size() - 1);
    auto         waves  = cosine_amplitudes(values);
    for (std::size_t k = 0; k < waves.size(); ++k)
      waves[k] *= cut_off.gain(static_cast<double>(k) / length);
    return values_of_cosine_amplitudes(std::move(waves));
  }

  double root_mean_square(const std::vector<double> &values)
  {
    double sum = 0.;
    for (const double value : values)
      sum += value * value;
    return values.empty() ? 0. : std::sqrt(sum / values.size());
  }
} // namespace RollingContact::Signals
