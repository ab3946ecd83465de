#ifndef rolling_contact_results_result_row_h
#define rolling_contact_results_result_row_h

#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * What the name in column solver tells.
   */
  struct SolvedBy
  {
    /** Another solver stood in, or the edges of the patch did not settle: the
     * laws hold, but the force may be off by more than elsewhere. */
    bool stood_in = false;
  };

  /**
   * How a state was solved, by the name that a run has left in column solver.
   */
  SolvedBy solved_by(const std::string &name);

  /**
   * One row of results.csv for a steady state, with its references and
   * invariants; ends the row. Throws ConvergenceError, once the row is there,
   * if a converged state breaks an invariant.
   */
  template <int dim>
  void add_result_row(const PairSpec         &scene,
                      const SteadyState<dim> &steady,
                      RunContext             &context);

  /**
   * The row of bodies that do not touch: zeros.
   */
  void add_open_row(const PairSpec &scene, ResultsTable &table);
} // namespace RollingContact

#endif
