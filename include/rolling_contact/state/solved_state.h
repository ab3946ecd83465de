#ifndef rolling_contact_state_solved_state_h
#define rolling_contact_state_solved_state_h

#include <rolling_contact/state/steady_state.h>

#include <string>

namespace RollingContact
{
  /**
   * "reason. Natural residual 1e-3, required 1e-10".
   */
  std::string
  shortfall(const SolverReport &solver, const double tolerance);

  /**
   * Throws ConvergenceError, with @p where in front, unless the state converged
   * on a patch inside its candidate zone.
   */
  template <int dim>
  void
  require_solved(const SceneParameters  &scene,
                 const SteadyState<dim> &steady,
                 const std::string      &where);
} // namespace RollingContact

#endif
