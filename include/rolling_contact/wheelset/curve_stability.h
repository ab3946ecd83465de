#ifndef rolling_contact_wheelset_curve_stability_h
#define rolling_contact_wheelset_curve_stability_h

#include <rolling_contact/scene/analysis_kind.h>

namespace RollingContact
{
  /**
   * Analysis = stability, and of the wheels of a wheelset in balance where
   * Stability/Wheel names them: its equilibrium is found on half-spaces, a row
   * of wheelset.csv. One wheel is then disturbed as any other state; both are
   * two states of a stability map, the left-hand one as a right-hand wheel in
   * the mirror, so that they share their modes, and stability.csv lists what
   * grows in each.
   */
  AnalysisKind stability_in_curves_kind();

  /**
   * Analysis = stability map, and of wheels of a wheelset in balance, which is
   * found anew for each state that moves it.
   */
  AnalysisKind stability_map_in_curves_kind();
} // namespace RollingContact

#endif
