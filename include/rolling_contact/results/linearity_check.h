#ifndef rolling_contact_results_linearity_check_h
#define rolling_contact_results_linearity_check_h

#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/scene/pair_spec.h>

namespace RollingContact
{
  /**
   * How far a state is from what linear elasticity at small strains holds for.
   * Each is the relative size, roughly, of what the theory leaves out.
   */
  struct StrainMeasures
  {
    double pressure = 0.; ///< peak pressure over the smaller Young's modulus
    double angle    = 0.; ///< half-width over the smaller radius of a body, rad
    double approach = 0.; ///< approach over the thinner body
  };

  StrainMeasures strain_measures(const PairSpec   &scene,
                                 const Resultants &result,
                                 const double      approach);

  /**
   * A warning for each measure beyond its limit: 0.05, 0.3 and 0.05.
   */
  void warn_of_large_strains(const StrainMeasures &measures, Log &log);
} // namespace RollingContact

#endif
