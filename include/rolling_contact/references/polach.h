#ifndef rolling_contact_references_polach_h
#define rolling_contact_references_polach_h

#include <rolling_contact/references/shen_hedrick_elkins.h>

namespace RollingContact::References
{
  /**
   * Polach's formula with constant friction, s = (x, y) the creepage, in its
   * direction:
   *   F = 2 mu N/pi (k_A e/(1 + (k_A e)^2) + atan(k_S e)),
   *   e = G pi a b C |s|/(4 mu N),  C^2 = (C11^2 x^2 + C22^2 y^2)/|s|^2
   * (Polach, Wear 258 (2005) 992-1000). With k_A + k_S = 2 small creepages give
   * kalker_forces() along x or y. It knows no spin: throws InputError for
   * any. Forces do not depend on the direction of flow.
   */
  TangentialForce polach(const Creepages          &creepages,
                         const HertzEllipse       &contact,
                         const CombinedElasticity &elasticity,
                         const double              friction_coefficient,
                         const double              adhesion_reduction = 1.,
                         const double              slip_reduction     = 1.);
} // namespace RollingContact::References

#endif
