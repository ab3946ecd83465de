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

  std::vector<double> low_pass(std::vector<double>  values,
                               const GridDirection &along,
                               const GridDirection &across,
                               const CutOff        &cut_off,
                               const double         stretch)
  {
    scale_waves(values, along, across, [&](const double k, const double l) {
      return cut_off.gain(std::hypot(k, stretch * l));
    });
    return values;
  }

  double root_mean_square(const std::vector<double> &values)
  {
    double sum = 0.;
    for (const double value : values)
      sum += value * value;
    return values.empty() ? 0. : std::sqrt(sum / values.size());
  }
} // namespace RollingContact::Signals
