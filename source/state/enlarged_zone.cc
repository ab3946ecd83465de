#include <rolling_contact/base/text.h>
#include <rolling_contact/state/adaptive_levels.h>
#include <rolling_contact/state/enlarged_zone.h>

namespace RollingContact
{
  namespace
  {
    /**
     * The state on a grading, its loads kept, to be solved.
     */
    template <int dim>
    SteadyState<dim>
    moved(const SteadyState<dim> &steady,
          const Grading<dim>     &grading,
          const SceneParameters  &scene,
          const StateDemands     &demands,
          RunContext             &context)
    {
      SteadyState<dim> next;
      next.grading = grading;
      next.level   = steady.level;
      next.change  = steady.change;
      next.limit   = steady.limit;
      {
        PhaseTimer::Scope phase(context.timer, Phase::mesh);
        next.pair =
          std::make_unique<RollingPair<dim>>(scene, grading, demands.pair);
      }
      PhaseTimer::Scope phase(context.timer, Phase::condensation);
      next.problem = next.pair->contact_problem(scene.contact);
      next.problem.loads.normal_load   = steady.problem.loads.normal_load;
      next.problem.loads.approach      = steady.problem.loads.approach;
      next.problem.loads.inclined_load = steady.problem.loads.inclined_load;
      next.problem.loads.creepages     = steady.problem.loads.creepages;
      next.problem.loads.forces        = steady.problem.loads.forces;
      next.state = transferred_state(steady, next.problem);
      return next;
    }
  } // namespace



  template <int dim>
  void
  solve_enlarging_zone(const SceneParameters &scene,
                       const StateDemands    &demands,
                       RunContext            &context,
                       SteadyState<dim>      &steady)
  {
    const unsigned int max_enlargements = 5;
    for (unsigned int k = 0;; ++k)
      {
        {
          PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
          solve_contact(scene, demands, steady);
          steady.result = resultants(steady.problem, steady.state);
        }
        // the patch of a state that is none means nothing
        if (k == max_enlargements || !steady.solver.converged ||
            !zone_too_small(steady))
          return;
        Grading<dim> grading = steady.grading;
        grading.enlarge_zone(1u << k);
        context.log.message("The patch reaches the border of the candidate "
                            "zone; the zone is enlarged to " +
                            significant(grading.zone_x, 3) +
                            " m on both sides.");
        steady.pair->release_statics();
        steady = moved(steady, grading, scene, demands, context);
      }
  }



  template void
  solve_enlarging_zone(const SceneParameters &,
                       const StateDemands &,
                       RunContext &,
                       SteadyState<2> &);
  template void
  solve_enlarging_zone(const SceneParameters &,
                       const StateDemands &,
                       RunContext &,
                       SteadyState<3> &);
} // namespace RollingContact
