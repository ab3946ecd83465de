#ifndef rolling_contact_report_state_summary_h
#define rolling_contact_report_state_summary_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * "active set, 4 normal and 7 tangential solves in 3 passes; natural residual
   * 1e-16 normal, 4e-16 tangential".
   */
  std::string
  work_of_solver(const SolverReport &solver);

  /**
   * Load and force of a state as the findings of a run.
   */
  template <int dim>
  void
  note_state(const SceneParameters  &scene,
             const SteadyState<dim> &steady,
             RunReport              &report);

  /**
   * Where fewer than five nodes touch.
   */
  void
  warn_of_few_nodes(const unsigned int n_touching, Log &log);
} // namespace RollingContact

#endif
