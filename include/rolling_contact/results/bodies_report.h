#ifndef rolling_contact_results_bodies_report_h
#define rolling_contact_results_bodies_report_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Log and note in run.json the sizes and cost of the static factors.
   */
  template <int dim>
  void describe_factors(const SteadyState<dim> &steady, RunContext &context);

  /**
   * Log how bodies from files are coupled to the interface.
   */
  template <int dim>
  void describe_surfaces(const RollingPair<dim> &pair, RunContext &context);

  /**
   * Log the sizes and cost of the bodies and note in run.json what was built
   * and what the scene did not need.
   */
  template <int dim>
  void describe_bodies(const SteadyState<dim> &steady, RunContext &context);
} // namespace RollingContact

#endif
