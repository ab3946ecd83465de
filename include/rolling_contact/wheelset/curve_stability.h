#ifndef rolling_contact_wheelset_curve_stability_h
#define rolling_contact_wheelset_curve_stability_h

#include <rolling_contact/scene/analysis_kind.h>

namespace RollingContact
{
  /**
   * Analysis = stability, which disturbs wheels of a wheelset where
   * Stability/Wheel names them: the equilibrium is found on half-spaces first,
   * a row of wheelset.csv. One wheel is then disturbed as any other state; both
   * are two states of a stability map, the left-hand one as a right-hand wheel
   * in the mirror, so that they share their modes, and stability.csv lists what
   * grows in each.
   */
  AnalysisKind stability_in_curves_kind();

  /**
   * Analysis = stability map, whose states may be wheels of a wheelset as well;
   * the equilibrium is found anew for each state that moves the wheelset.
   */
  AnalysisKind stability_map_in_curves_kind();
} // namespace RollingContact

#endif
