#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/state/initial_contact.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * The edge law needs the static compliance, which a run with inertia has
     * at most to start from.
     */
    SlipOperatorKind
    operator_in_time(const SceneParameters &scene)
    {
      const SlipOperatorKind kind = scene.contact.slip_operator;
      return scene.time.inertia && kind == SlipOperatorKind::calibrated
               ? SlipOperatorKind::upwind_2
               : kind;
    }



    template <int dim>
    void
    start_steadily(const SceneParameters  &scene,
                   const StateDemands     &demands,
                   const DrivingFunctions &histories,
                   RunContext             &context,
                   InitialContact<dim>    &initial)
    {
      PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
      SteadyState<dim> &contact = initial.contact;
      ContactProblem   &problem = contact.problem;
      problem.loads.creepages   = histories.creepages(0.);
      problem.loads.forces      = histories.forces(0.);
      problem.loads.speed       = std::abs(histories.speed.value(0.));
      if (histories.normal_load)
        problem.loads.normal_load = histories.normal_load->value(0.);
      else
        problem.loads.approach = histories.approach->value(0.);
      const MovingSurfaces &surfaces   = contact.pair->moving_surfaces();
      std::vector<double>   smooth_gap = problem.loads.gap;
      const auto heights = surfaces.heights(problem.operators.positions(), 0.);
      for (std::size_t i = 0; i < heights.size(); ++i)
        problem.loads.gap[i] -= heights[i];
      solve_contact(scene, demands, contact);
      problem.loads.gap = std::move(smooth_gap); // for other steps
      if (!contact.solver.converged)
        throw ConvergenceError("The steady initial state did not converge: " +
                               contact.solver.reason +
                               "; try Time/Initial state = rest.");
      initial.motion->start_from(problem, contact.state);
    }



    /**
     * The pair on its mesh, without any compliance.
     */
    template <int dim>
    SteadyState<dim>
    mesh_only(const SceneParameters &scene,
              const StateDemands    &demands,
              RunContext            &context)
    {
      PhaseTimer::Scope   phase(context.timer, Phase::mesh);
      const PatchEstimate patch = estimate_patch(scene);
      SteadyState<dim>    contact;
      contact.grading = make_grading<dim>(scene,
                                          demands,
                                          patch,
                                          scene.mesh.elements_across_patch,
                                          scene.mesh.offset());
      contact.pair    = std::make_unique<RollingPair<dim>>(scene,
                                                        contact.grading,
                                                        demands.pair,
                                                        false);
      return contact;
    }



    template <int dim>
    InitialContact<dim>
    make_massless(const SceneParameters  &scene,
                  const StateDemands     &demands,
                  const DrivingFunctions &histories,
                  RunContext             &context)
    {
      InitialContact<dim> initial;
      initial.contact = solve_steady_state<dim>(scene, demands, context);
      initial.motion  = make_quasi_static_rolling<dim>(*initial.contact.pair);
      if (scene.time.initial_state == InitialState::steady)
        start_steadily(scene, demands, histories, context, initial);
      else
        initial.contact.state = open_state(initial.contact.problem);
      return initial;
    }



    template <int dim>
    InitialContact<dim>
    make_inertial(const SceneParameters  &scene,
                  const StateDemands     &demands,
                  const DrivingFunctions &histories,
                  const SlipOperatorKind  slip_operator,
                  RunContext             &context)
    {
      const bool steady = scene.time.initial_state == InitialState::steady;
      InitialContact<dim> initial;
      SteadyState<dim>   &contact = initial.contact;
      contact = steady ? solve_steady_state<dim>(scene, demands, context)
                       : mesh_only<dim>(scene, demands, context);
      {
        PhaseTimer::Scope phase(context.timer, Phase::mass);
        initial.motion = make_inertial_rolling<dim>(scene, *contact.pair);
      }
      ContactParameters in_time = scene.contact;
      in_time.slip_operator     = slip_operator;
      contact.problem           = contact.pair->contact_problem(
        in_time,
        steady ? std::move(contact.problem.operators).W()
                         : contact.pair->pair_compliance({}));
      if (steady)
        {
          start_steadily(scene, demands, histories, context, initial);
          contact.pair->release_statics();
        }
      else
        contact.state = open_state(contact.problem);
      return initial;
    }
  } // namespace



  template <int dim>
  InitialContact<dim>
  make_initial_contact(const SceneParameters  &scene,
                       const PairDemands      &demands,
                       const DrivingFunctions &histories,
                       RunContext             &context)
  {
    const SlipOperatorKind slip_operator = operator_in_time(scene);
    if (slip_operator != scene.contact.slip_operator &&
        scene.contact.friction_coefficient > 0.)
      context.log.message("With inertia B1 is `upwind 2`: the edge law of "
                          "`calibrated` needs the static compliance.");
    StateDemands in_time = demands_in_time(demands);
    if (scene.time.inertia) // the motion starts from them
      in_time.pair.displacements = true;
    return scene.time.inertia
             ? make_inertial<dim>(
                 scene, in_time, histories, slip_operator, context)
             : make_massless<dim>(scene, in_time, histories, context);
  }



  template InitialContact<2>
  make_initial_contact<2>(const SceneParameters &,
                          const PairDemands &,
                          const DrivingFunctions &,
                          RunContext &);
  template InitialContact<3>
  make_initial_contact<3>(const SceneParameters &,
                          const PairDemands &,
                          const DrivingFunctions &,
                          RunContext &);
} // namespace RollingContact
