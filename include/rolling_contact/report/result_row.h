#ifndef rolling_contact_report_result_row_h
#define rolling_contact_report_result_row_h

#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * One row of results.csv for a steady state, with its references and
   * invariants; ends the row. Throws ConvergenceError, once the row is there,
   * if a converged state breaks an invariant.
   */
  template <int dim>
  void
  add_result_row(const SceneParameters  &scene,
                 const SteadyState<dim> &steady,
                 RunContext             &context);

  /**
   * The row of bodies that do not touch: zeros.
   */
  void
  add_open_row(const SceneParameters &scene, ResultsTable &table);
} // namespace RollingContact

#endif
