#include "timoshenko_rail.h"

#include <rolling_contact/references/checks.h>

#include <cmath>

namespace RollingContact::References
{
  std::complex<double> TimoshenkoRail::receptance(const double frequency,
                                                  const double x) const
  {
    using Complex = std::complex<double>;
    check_not_negative("Frequency", frequency, "Hz");
    check_finite("Distance", x, "m");
    const Complex i(0., 1.), steel(1., loss_factor),
      pads(1., foundation_loss_factor);
    const double  omega    = 2 * std::acos(-1.) * frequency;
    const Complex bending  = bending_stiffness * steel,
                  shear    = shear_stiffness * steel,
                  stiff    = foundation_stiffness * pads - mass * omega * omega,
                  rotation = shear - rotary_inertia * omega * omega;
    // D(k) = a k^4 + b k^2 + c
    const Complex a = shear * bending,
                  b = shear * rotation + stiff * bending - shear * shear,
                  c = stiff * rotation, root = std::sqrt(b * b - 4. * a * c);
    Complex sum = 0.;
    for (const double sign : {1., -1.})
      {
        Complex k = std::sqrt((-b + sign * root) / (2. * a));
        if (k.imag() < 0.)
          k = -k;
        sum += (bending * k * k + rotation) /
               (4. * a * k * k * k + 2. * b * k) *
               std::exp(i * k * std::abs(x));
      }
    return i * sum;
  }
} // namespace RollingContact::References
