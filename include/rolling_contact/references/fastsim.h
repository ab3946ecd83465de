#ifndef rolling_contact_references_fastsim_h
#define rolling_contact_references_fastsim_h

#include <rolling_contact/references/shen_hedrick_elkins.h>

namespace RollingContact::References
{
  /**
   * FASTSIM (Kalker 1982): the surface as a bed of springs. Along strips of the
   * ellipse, from the leading edge on, a particle's traction grows by
   *   dq_x = -(x/L1 - spin Y/L3) dX,  dq_y = -(y/L2 + spin X/L3) dX
   * and is cut back to mu (2 N/(pi a b)) (1 - X^2/a^2 - Y^2/b^2), with
   *   L1 = 8 a/(3 G C11),  L2 = 8 a/(3 G C22),
   *   L3 = pi a sqrt(a/b)/(4 G C23),
   * so that small creepages give kalker_forces(). @p n_strips strips of as many
   * steps; 200 leave 4e-4 of mu N. The theory itself is 5 to 10 % off, more
   * where spin dominates. The flow direction is that of kalker_forces().
   */
  TangentialForce fastsim(const Creepages          &creepages,
                          const HertzEllipse       &contact,
                          const CombinedElasticity &elasticity,
                          const double              friction_coefficient,
                          const int                 flow_direction = 1,
                          const unsigned int        n_strips       = 200);
} // namespace RollingContact::References

#endif
