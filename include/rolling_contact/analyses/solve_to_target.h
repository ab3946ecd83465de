#ifndef rolling_contact_analyses_solve_to_target_h
#define rolling_contact_analyses_solve_to_target_h

#include <rolling_contact/results/target_error.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/adaptive_levels.h>

#include <functional>

namespace RollingContact
{
  /**
   * A state, with its levels, on the mesh of the scene, or on the one that its
   * `Mesh/Target error` asks for, which the scene then has. What was taken and
   * why is said and noted for run.json. A state whose bound is above the target
   * all the same is meshed and solved again, twice at most. Calls @p on_level
   * for the states to be kept. Throws InputError if no mesh keeps the target.
   */
  template <int dim>
  SteadyState<dim> solve_to_target(
    Situation                                           &scene,
    const StateDemands                                  &demands,
    const TargetDemands                                 &targets,
    RunContext                                          &context,
    const std::function<void(const SteadyState<dim> &)> &on_level);

  /**
   * Warns if the largest error bound of the run is above `Mesh/Target error`.
   */
  void warn_of_missed_target(const Situation &scene, RunContext &context);
} // namespace RollingContact

#endif
