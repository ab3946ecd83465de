#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/time/initial_contact.h>
#include <rolling_contact/vibration/excitation.h>
#include <rolling_contact/vibration/reduced_rolling.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * The edge law needs the compliance of the surface at rest, which nodes
     * with mass do not have within a step; bodies by their modes have.
     */
    SlipOperatorKind operator_in_time(const Situation &scene)
    {
      const SlipOperatorKind kind = scene.contact.slip_operator;
      return scene.inputs->time.inertia &&
                 !scene.inputs->has_reduced_bodies() &&
                 kind == SlipOperatorKind::calibrated
               ? SlipOperatorKind::upwind_2
               : kind;
    }

    template <int dim>
    void start_steadily(const Situation        &scene,
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
    SteadyState<dim> mesh_only(const Situation    &scene,
                               const StateDemands &demands,
                               RunContext         &context)
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
    InitialContact<dim> make_massless(const Situation        &scene,
                                      const StateDemands     &demands,
                                      const DrivingFunctions &histories,
                                      RunContext             &context)
    {
      InitialContact<dim> initial;
      initial.contact = solve_steady_state<dim>(scene, demands, context);
      initial.motion  = make_quasi_static_rolling<dim>(*initial.contact.pair);
      if (scene.inputs->time.initial_state == InitialState::steady)
        start_steadily(scene, demands, histories, context, initial);
      else
        initial.contact.state = open_state(initial.contact.problem);
      return initial;
    }

    template <int dim>
    InitialContact<dim> make_inertial(const Situation        &scene,
                                      const StateDemands     &demands,
                                      const DrivingFunctions &histories,
                                      const SlipOperatorKind  slip_operator,
                                      RunContext             &context)
    {
      const bool steady =
        scene.inputs->time.initial_state == InitialState::steady;
      InitialContact<dim> initial;
      SteadyState<dim>   &contact = initial.contact;
      contact = steady ? solve_steady_state<dim>(scene, demands, context)
                       : mesh_only<dim>(scene, demands, context);
      {
        PhaseTimer::Scope phase(context.timer, Phase::mass);
        initial.motion = make_inertial_rolling<dim>(scene.wheel,
                                                    scene.inputs->time,
                                                    *contact.pair);
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

    /**
     * Friction that falls in another way than at each node by its own speed:
     * from now on without the law of the problem.
     */
    template <int dim>
    void take_over_friction(const Situation     &scene,
                            InitialContact<dim> &initial)
    {
      ContactProblem        &problem  = initial.contact.problem;
      const FrictionResponse response = scene.inputs->friction_response();
      if (problem.n_tangential() == 0 || !problem.loads.friction_law ||
          response == FrictionResponse::node)
        return;
      PatchFriction friction(problem,
                             initial.contact.state,
                             scene.contact.friction_memory);
      initial.undisturbed.friction = friction.memory();
      friction.begin_step(0.);
      problem.loads.friction_law.reset();
      problem.loads.friction = friction.coefficients();
      initial.contact.state.friction.clear();
      if (response == FrictionResponse::patch_mean)
        initial.friction = friction;
    }

    /**
     * Begin with another motion of reduced bodies.
     */
    template <int dim, typename Change>
    void change_motion(InitialContact<dim> &initial, const Change &change)
    {
      const SteadyState<dim> &contact = initial.contact;
      PairMotion              motion  = initial.motion->save();
      change(motion.modes);
      initial.motion->restore(motion, contact.problem, contact.state);
    }

    /**
     * Begin in a vibration that grows, see Time/Excite mode.
     */
    template <int dim>
    void excite(const Situation       &scene,
                const LinearContact   &linear,
                const StabilityPencil &pencil,
                const double           h,
                InitialContact<dim>   &initial,
                RunContext            &context)
    {
      const StabilityMode mode =
        pencil.mode(vibration_near(initial.eigenvalues,
                                   scene.inputs->time.excite_mode,
                                   "Time/Excite mode"));
      const Excitation vibration(*initial.motion->reduced_pair(),
                                 linear,
                                 mode,
                                 scene.inputs->time.excite_velocity);
      change_motion(initial,
                    [&](ReducedState &state) { vibration.add_to(state, h); });
      if (initial.friction)
        {
          const double t = -h / 2, dt = 1e-3 * h;
          initial.friction->disturb(vibration.friction(t),
                                    (vibration.friction(t + dt) -
                                     vibration.friction(t - dt)) /
                                      (2 * dt));
        }
      initial.excited = mode.s;
      context.results.set("excited_frequency_Hz", mode.frequency());
      context.results.set("excited_growth_1/s", mode.growth());
      context.report.set_finding(
        "start",
        "a vibration of " + significant(mode.frequency(), 6) + " Hz that " +
          (mode.growth() > 0. ? "grows by " : "decays by ") +
          significant(std::abs(mode.growth()), 5) +
          " 1/s while it is small, of " +
          significant(scene.inputs->time.excite_velocity, 4) +
          " m/s at the start");
    }

    /**
     * The vibrations about the state that reduced bodies start from, and one of
     * them excited; @p linear as the law was.
     */
    template <int dim>
    void vibrate(const Situation     &scene,
                 const LinearContact &linear,
                 const double         h,
                 InitialContact<dim> &initial,
                 RunContext          &context)
    {
      PhaseTimer::Scope     phase(context.timer, Phase::eigenvalues);
      const StabilityPencil pencil(*initial.motion->reduced_pair(), linear);
      initial.eigenvalues = pencil.eigenvalues();
      if (scene.inputs->time.excite_mode > 0.)
        excite(scene, linear, pencil, h, initial, context);
    }

    /**
     * In a steady state: friction in time, and the vibration that is wanted.
     */
    template <int dim>
    void begin_motion(const Situation        &scene,
                      const DrivingFunctions &histories,
                      const double            h,
                      InitialContact<dim>    &initial,
                      RunContext             &context)
    {
      std::optional<LinearContact> linear; // of the law, if one falls
      if (scene.inputs->time.excite_mode > 0. ||
          (scene.inputs->wants_spectra() &&
           scene.inputs->why_no_eigenvalues().empty()))
        linear = linear_contact(initial.contact.problem,
                                initial.contact.state,
                                {std::abs(histories.speed.value(0.)),
                                 scene.inputs->friction_response(),
                                 scene.contact.friction_memory});
      take_over_friction(scene, initial);
      if (linear)
        vibrate(scene, *linear, h, initial, context);
    }
  } // namespace

  template <int dim>
  ReducedBodies<dim> make_reduced_bodies(const Situation   &scene,
                                         const PairDemands &demands,
                                         RunContext        &context)
  {
    StateDemands in_time = demands_in_time(demands);
    in_time.pair.modes   = true;
    ReducedBodies<dim> bodies;
    bodies.base = solve_steady_state<dim>(scene, in_time, context);
    bodies.modes =
      std::make_shared<ModalBodies<dim>>(scene,
                                         scene.inputs->modes,
                                         bodies.base.pair->bodies(),
                                         scene.inputs->modes.cut_off(),
                                         context);
    return bodies;
  }

  template <int dim>
  InitialContact<dim> make_reduced_contact(const Situation          &scene,
                                           const ReducedBodies<dim> &bodies,
                                           const DrivingFunctions   &histories,
                                           const double              h,
                                           const Disturbance *disturbance,
                                           RunContext        &context)
  {
    InitialContact<dim> initial;
    SteadyState<dim>   &contact = initial.contact;
    contact                     = bodies.base;
    DenseMatrix W               = contact.problem.operators.W().dense();
    initial.modes               = bodies.modes;
    auto reduced                = std::make_unique<ReducedRolling<dim>>(
      bodies.modes,
      *contact.pair,
      W,
      RollingConditions(scene, scene.inputs->stability));
    // steps hold still at what is at rest for the modes
    W              = reduced->compliance_at_rest(std::move(W));
    initial.motion = std::move(reduced);
    contact.problem =
      contact.pair->contact_problem(scene.contact, std::move(W));
    start_steadily(
      scene, demands_in_time(PairDemands()), histories, context, initial);
    initial.undisturbed.motion = *initial.motion->reduced_state();
    begin_motion(scene, histories, h, initial, context);
    if (disturbance == nullptr)
      return initial;
    change_motion(initial, [&](ReducedState &state) {
      state.add(1., disturbance->motion);
    });
    const auto &[share, target] = disturbance->friction;
    if (initial.friction)
      initial.friction->disturb(share,
                                (target - share) /
                                  scene.contact.friction_memory);
    return initial;
  }

  template <int dim>
  InitialContact<dim> make_initial_contact(const Situation        &scene,
                                           const PairDemands      &demands,
                                           const DrivingFunctions &histories,
                                           const double            h,
                                           RunContext             &context)
  {
    const SlipOperatorKind slip_operator = operator_in_time(scene);
    if (slip_operator != scene.contact.slip_operator &&
        scene.contact.friction_coefficient > 0.)
      context.log.message("With the inertia of all unknowns B1 is `upwind 2`: "
                          "the edge law of `calibrated` needs nodes without "
                          "mass.");
    StateDemands in_time = demands_in_time(demands);
    if (scene.inputs->time.inertia) // the motion starts from them
      in_time.pair.displacements = true;
    if (scene.inputs->has_reduced_bodies())
      return make_reduced_contact(scene,
                                  make_reduced_bodies<dim>(scene,
                                                           in_time.pair,
                                                           context),
                                  histories,
                                  h,
                                  nullptr,
                                  context);
    InitialContact<dim> initial =
      scene.inputs->time.inertia
        ? make_inertial<dim>(scene, in_time, histories, slip_operator, context)
        : make_massless<dim>(scene, in_time, histories, context);
    begin_motion(scene, histories, h, initial, context);
    return initial;
  }

  template ReducedBodies<2>
  make_reduced_bodies<2>(const Situation &, const PairDemands &, RunContext &);
  template ReducedBodies<3>
  make_reduced_bodies<3>(const Situation &, const PairDemands &, RunContext &);
  template InitialContact<2> make_reduced_contact(const Situation &,
                                                  const ReducedBodies<2> &,
                                                  const DrivingFunctions &,
                                                  const double,
                                                  const Disturbance *,
                                                  RunContext &);
  template InitialContact<3> make_reduced_contact(const Situation &,
                                                  const ReducedBodies<3> &,
                                                  const DrivingFunctions &,
                                                  const double,
                                                  const Disturbance *,
                                                  RunContext &);
  template InitialContact<2> make_initial_contact<2>(const Situation &,
                                                     const PairDemands &,
                                                     const DrivingFunctions &,
                                                     const double,
                                                     RunContext &);
  template InitialContact<3> make_initial_contact<3>(const Situation &,
                                                     const PairDemands &,
                                                     const DrivingFunctions &,
                                                     const double,
                                                     RunContext &);
} // namespace RollingContact
