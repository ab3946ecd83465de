#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/polach.h>

#include <cmath>

namespace RollingContact::References
{
  TangentialForce polach(const Creepages          &creepages,
                         const HertzEllipse       &contact,
                         const CombinedElasticity &elasticity,
                         const double              friction_coefficient,
                         const double              adhesion_reduction,
                         const double              slip_reduction)
  {
    check_not_negative("Friction coefficient", friction_coefficient);
    if (creepages.spin != 0.)
      reject("Spin", creepages.spin, "1/m", "0, as Polach's formula has none");
    const double bound = friction_coefficient * contact.load(),
                 slip  = std::hypot(creepages.x, creepages.y);
    if (!(bound > 0. && slip > 0.))
      return {0., 0.};
    const auto kalker =
      kalker_coefficients(contact.half_width_x / contact.half_width_y,
                          elasticity.poisson_ratio);
    // C |s|
    const double stiff_slip =
      std::hypot(kalker.C11 * creepages.x, kalker.C22 * creepages.y);
    const double e = elasticity.shear_modulus * pi * contact.half_width_x *
                     contact.half_width_y * stiff_slip / (4 * bound),
                 adhesion = adhesion_reduction * e;
    const double force =
      2 * bound / pi *
      (adhesion / (1 + adhesion * adhesion) + std::atan(slip_reduction * e));
    return {-force * creepages.x / slip, -force * creepages.y / slip};
  }
} // namespace RollingContact::References
