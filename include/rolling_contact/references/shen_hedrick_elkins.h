#ifndef rolling_contact_references_shen_hedrick_elkins_h
#define rolling_contact_references_shen_hedrick_elkins_h

#include <rolling_contact/references/kalker.h>

namespace RollingContact::References
{
  /**
   * Tangential force (N) on the wheel.
   */
  struct TangentialForce
  {
    double x;
    double y;
  };

  /**
   * Kalker's linear force F, saturated (Shen, Hedrick and Elkins 1983):
   * F (1 - e/3 + e^2/27) with e = |F|/(mu N) <= 3, else mu N in the direction
   * of F. A heuristic, not for contacts where spin dominates. The flow
   * direction is that of kalker_forces().
   */
  TangentialForce shen_hedrick_elkins(const Creepages          &creepages,
                                      const HertzEllipse       &contact,
                                      const CombinedElasticity &elasticity,
                                      const double friction_coefficient,
                                      const int    flow_direction = 1);
} // namespace RollingContact::References

#endif
