#ifndef rolling_contact_state_enlarged_zone_h
#define rolling_contact_state_enlarged_zone_h

#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Solve a state that has its mesh, under the loads of its problem, from where
   * it is. If the patch reaches the border of the candidate zone, bodies and
   * compliance are made again for a larger zone with elements of the same size,
   * which is said, the state is transferred and solved there. A state that does
   * not converge stays as it is, and so does one that still reaches the border
   * after five enlargements.
   */
  template <int dim>
  void
  solve_enlarging_zone(const SceneParameters &scene,
                       const StateDemands    &demands,
                       RunContext            &context,
                       SteadyState<dim>      &steady);
} // namespace RollingContact

#endif
