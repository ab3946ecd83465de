#include "two_mass_flutter.h"

#include <rolling_contact/references/checks.h>

namespace RollingContact::References
{
  double TwoMassFlutter::critical_friction() const
  {
    check_positive("Coupling k12", k12, "1/s^2");
    check_positive("Contact stiffness k3", k3, "1/s^2");
    check_not_negative("Damping c1", c1, "1/s");
    check_not_negative("Damping c2", c2, "1/s");
    if (c1 + c2 == 0.)
      return (k12 + (k11 - k22) * (k11 - k22) / (4 * k12)) / k3;
    // s^4 + a3 s^3 + a2 s^2 + a1 s + a0, marginal: a0 = a1 (a3 a2 - a1) / a3^2
    const double a3 = c1 + c2, a2 = k11 + k22 + c1 * c2,
                 a1 = c1 * k22 + c2 * k11, a0 = a1 * (a3 * a2 - a1) / (a3 * a3);
    return (a0 - k11 * k22 + k12 * k12) / (k3 * k12);
  }

  std::complex<double>
  TwoMassFlutter::undamped_eigenvalue(const double mu) const
  {
    const std::complex<double> mean = (k11 + k22) / 2,
                               half = std::sqrt(std::complex<double>(
                                 (k11 - k22) * (k11 - k22) / 4 +
                                 k12 * (k12 - mu * k3)));
    // s^2 = -mean +- half, both roots: growth is that of either sign
    std::complex<double> best = 0.;
    for (const double sign : {1., -1.})
      {
        std::complex<double> s = std::sqrt(-mean + sign * half);
        if (s.imag() < 0.)
          s = -s;
        if (best == 0. || s.real() > best.real())
          best = s;
      }
    return best;
  }
} // namespace RollingContact::References
