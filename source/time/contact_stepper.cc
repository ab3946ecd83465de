#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/invariants.h>
#include <rolling_contact/solvers/compliance_update.h>
#include <rolling_contact/solvers/force_control.h>
#include <rolling_contact/time/contact_stepper.h>
#include <rolling_contact/time/hub_motion.h>
#include <rolling_contact/time/initial_contact.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    template <int dim>
    InitialContact<dim> begin(const Situation   &scene,
                              const PairDemands &demands,
                              RunContext        &context)
    {
      const DrivingFunctions histories =
        scene.inputs->time.histories(scene.contact, scene.inputs->prm_folder);
      return make_initial_contact<dim>(
        scene,
        demands,
        histories,
        scene.inputs->time.steps(histories.speed).length,
        context);
    }
  } // namespace

  template <int dim>
  ContactStepper<dim>::ContactStepper(const Situation   &scene,
                                      const PairDemands &demands,
                                      RunContext        &context)
    : ContactStepper(scene, begin<dim>(scene, demands, context), context)
  {}

  template <int dim>
  ContactStepper<dim>::ContactStepper(const Situation    &scene,
                                      InitialContact<dim> initial,
                                      RunContext         &context)
    : scene(scene)
    , context(context)
    , histories(
        scene.inputs->time.histories(scene.contact, scene.inputs->prm_folder))
    , travelled(histories.speed,
                scene.inputs->time.steps(histories.speed).length)
    , contact(std::move(initial.contact))
    , motion(std::move(initial.motion))
    , solver(make_contact_solver(scene.solver.solver, scene.solver.controls))
    , patch_friction(initial.friction)
    , modal(std::move(initial.modes))
    , undisturbed(std::move(initial.undisturbed))
    , excitation(initial.excited)
  {
    undeformed_gap = contact.problem.loads.gap;
    vibrations     = std::move(initial.eigenvalues);
    border         = contact.pair->trace().border_nodes();
    const WatchedPoints<dim> points(scene,
                                    scene.inputs->points_with_velocities(),
                                    contact.pair->bodies(),
                                    [&](const std::string &text) {
                                      context.log.message(text);
                                    });
    if (points.n_values() > 0)
      motion->watch(points);
    watched_position = motion->watched_displacement();
    if (scene.inputs->time.initial_state == InitialState::rest)
      contact.problem.loads.creepages = histories.creepages(0.);
    slip = slip_memory(contact.problem,
                       contact.state,
                       std::abs(histories.speed.value(0.)));
    if (!scene.inputs->time.hold_approach)
      return;
    histories.normal_load.reset();
    histories.approach = TimeFunction(contact.state.approach);
    contact.problem.loads.normal_load.reset();
    contact.problem.loads.inclined_load.reset();
  }

  template <int dim>
  void ContactStepper<dim>::set_time_step(const double h)
  {
    if (h == time_step)
      return;
    PhaseTimer::Scope phase(context.timer, Phase::condensation);
    motion->set_time_step(h);
    time_step                   = h;
    ContactOperators &operators = contact.problem.operators;
    if (motion->compliance_depends_on_step())
      operators.set_compliance(motion->compliance());
    operators.set_time_scaling({motion->displacement_factor(), 0.});
  }

  template <int dim>
  void ContactStepper<dim>::set_drive_functions(const DrivingFunctions &driving)
  {
    if (driving.normal_load.has_value() != histories.normal_load.has_value() ||
        driving.approach.has_value() != histories.approach.has_value())
      throw std::logic_error("Load and approach of a stepper stay what they "
                             "are.");
    histories = driving;
  }

  template <int dim>
  void ContactStepper<dim>::apply_free_motion(const FreeMotion &free,
                                              const double      speed)
  {
    const std::size_t n_nodes = contact.problem.n_nodes();
    ContactLoads     &loads   = contact.problem.loads;
    loads.gap                 = undeformed_gap;
    for (std::size_t i = 0; i < step_heights.size(); ++i)
      loads.gap[i] -= step_heights[i];
    for (std::size_t i = 0; i < free.gap.size(); ++i)
      loads.gap[i] += free.gap[i];
    if (contact.problem.n_tangential() == 0)
      return;
    loads.speed             = speed;
    loads.free_displacement = NodalField(n_nodes, free.displacement);
    loads.free_slip         = NodalField(n_nodes, free.velocity);
    for (double &value : loads.free_slip)
      value /= speed;
    contact.problem.operators.set_time_scaling(
      {motion->displacement_factor(),
       free.velocity_factor / (speed * time_step)});
  }

  template <int dim>
  void ContactStepper<dim>::solve(const double speed)
  {
    PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
    const auto        solve_here = [&]() {
      solve_given_creepages(speed);
      return contact.solver;
    };
    contact.solver = contact.problem.loads.forces.any()
                       ? solve_for_forces(solve_here,
                                          scene.solver.controls,
                                          contact.problem,
                                          contact.state)
                       : solve_here();
  }

  template <int dim>
  void ContactStepper<dim>::solve_given_creepages(const double speed)
  {
    ContactLoads        &loads = contact.problem.loads;
    const SlipWithinStep answered(slip,
                                  motion->laws_in_the_middle() ? 1. : theta(),
                                  speed,
                                  loads);
    unsigned int         n_iterations = 0;
    if (patch_friction)
      patch_friction->begin_step(time_step);
    do
      {
        if (patch_friction)
          loads.friction = patch_friction->coefficients();
        contact.solver = solve_updating_compliance(
          *solver,
          [&](const auto &forces, const bool) {
            return motion->response(forces);
          },
          contact.pair->compliance_is_exact(),
          scene.solver.controls,
          contact.problem,
          contact.state);
        n_iterations += contact.solver.iterations;
    } while (contact.solver.converged &&
             (answered.bring_to_rest(contact.problem, contact.state, loads) ||
              (patch_friction &&
               !patch_friction->agrees(contact.problem, contact.state))));
    if (contact.solver.converged && patch_friction && patch_friction->failed())
      {
        contact.solver.converged = false;
        contact.solver.reason    = "friction and its memory do not agree";
      }
    contact.solver.iterations = n_iterations;
  }

  template <int dim>
  bool ContactStepper<dim>::take_part(const double time,
                                      const double h,
                                      StepOutcome &outcome)
  {
    set_time_step(h);
    set_drive(time, h);
    outcome.speed = histories.speed.value(time + h);
    const bool smooth =
      !histories.jump_between(time, time + h) && !follows_jump(time, h);
    if (contact.problem.n_tangential() > 0 &&
        outcome.speed * scene.contact.flow() <= 0.)
      throw InputError("Time/Speed is " + significant(outcome.speed, 6) +
                       " m/s at t = " + significant(time + h, 6) +
                       " s: with friction it must keep the sign of "
                       "Contact/Speed.");
    {
      PhaseTimer::Scope phase(context.timer, Phase::body_solves);
      apply_free_motion(
        motion->begin_step(hub_acceleration_within(histories, time, h), smooth),
        std::abs(outcome.speed));
    }
    const ContactState previous         = contact.state;
    const Creepages    creepages_before = contact.problem.loads.creepages;
    solve(std::abs(outcome.speed));
    outcome.solver.reason   = contact.solver.reason;
    outcome.solver.residual = contact.solver.residual;
    if (!contact.solver.converged)
      {
        contact.state                   = previous;
        contact.problem.loads.creepages = creepages_before;
        return false;
      }
    contact.restored = false;
    check_invariants(invariants(contact.problem, contact.state),
                     scene.solver.controls.tolerance,
                     "t = " + significant(time + h, 9) + " s: ");
    finish_part(previous, time, h, smooth, outcome);
    return true;
  }

  template <int dim>
  void ContactStepper<dim>::finish_part(const ContactState &previous,
                                        const double        time,
                                        const double        h,
                                        const bool          smooth,
                                        StepOutcome        &outcome)
  {
    const ContactProblem &problem = contact.problem;
    {
      PhaseTimer::Scope phase(context.timer, Phase::body_solves);
      const StepEnergy  part = motion->end_step(problem, contact.state);
      outcome.energy.kinetic = part.kinetic;
      outcome.energy.strain  = part.strain;
      outcome.energy.add_changes(part);
    }
    if (patch_friction)
      {
        patch_friction->end_step();
        outcome.friction_share = patch_friction->memory().share;
      }
    outcome.contact_velocity = contact_velocity();
    ++outcome.n_parts;
    outcome.force_lag = (1 - theta()) * h;
    outcome.surface_work += surface_work(previous, time, h);
    outcome.solver.iterations += contact.solver.iterations;
    outcome.solver.solver = contact.solver.solver;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      outcome.n_impacts +=
        contact.state.pressure[i] > 0. && previous.pressure[i] == 0.;
    if (problem.n_tangential() == 0)
      return;
    const Uniqueness several = uniqueness(problem, contact.state);
    if (several.ratio > outcome.several.ratio)
      outcome.several = several;
    outcome.friction += friction_heat(h, std::abs(outcome.speed), smooth);
    const auto states =
      node_states(tangential_problem(problem, contact.state), contact.state);
    outcome.n_sticking =
      std::count(states.begin(), states.end(), NodeState::stick);
  }

  template <int dim>
  void ContactStepper<dim>::take_in_parts(const double       time,
                                          const double       h,
                                          const unsigned int n_halvings,
                                          StepOutcome       &outcome)
  {
    if (take_part(time, h, outcome))
      return;
    if (n_halvings == scene.inputs->time.maximum_halvings)
      throw ConvergenceError(
        "The contact solver did not converge at t = " + significant(time, 9) +
        " s with a step of " + significant(h, 3) +
        " s: " + shortfall(outcome.solver, scene.solver.controls.tolerance) +
        ". Take a smaller Time/Time step, more Time/Maximum halvings or "
        "another Contact/Solver.");
    context.log.message(
      "t = " + significant(time, 6) + " s: the contact solve failed (" +
      outcome.solver.reason + "); the step is halved to " +
      significant(h / 2, 3) + " s and the matrix factorised again.");
    take_in_parts(time, h / 2, n_halvings + 1, outcome);
    take_in_parts(time + h / 2, h / 2, n_halvings + 1, outcome);
  }

  template <int dim>
  StepOutcome ContactStepper<dim>::advance(const double time, const double h)
  {
    const ContactState before          = contact.state;
    const SlipMemory   slip_before     = slip;
    const auto         friction_before = patch_friction;
    motion->remember();
    try
      {
        return take_whole_step(time, h);
      }
    catch (...)
      {
        contact.state    = before;
        slip             = slip_before;
        patch_friction   = friction_before;
        contact.restored = true; // the drive is that of the failed step
        motion->go_back();
        throw;
      }
  }

  template <int dim>
  StepOutcome ContactStepper<dim>::take_whole_step(const double time,
                                                   const double h)
  {
    StepOutcome outcome;
    take_in_parts(time, h, 0, outcome);
    if (!std::isfinite(motion->stored_energy()))
      throw ConvergenceError(
        "The energy of the bodies is not a number at t = " +
        significant(time + h, 9) + " s.");
    if (reaches_border(border, contact.problem, contact.state.pressure))
      throw ConvergenceError(
        "The patch reaches the border of the candidate zone at t = " +
        significant(time + h, 9) + " s: take a larger Mesh/Candidate zone.");
    contact.result         = resultants(contact.problem, contact.state);
    outcome.wheel_velocity = motion->wheel_velocity();
    outcome.point_velocity = motion->watched_displacement();
    for (std::size_t i = 0; i < watched_position.size(); ++i)
      {
        const double now          = outcome.point_velocity[i];
        outcome.point_velocity[i] = (now - watched_position[i]) / h;
        watched_position[i]       = now;
      }
    const MovingSurfaces &surfaces = contact.pair->moving_surfaces();
    if (surfaces.in_use())
      outcome.surface_height =
        surfaces.height(0., 0., travelled.value(time + h - outcome.force_lag));
    return outcome;
  }

  template class ContactStepper<2>;
  template class ContactStepper<3>;
} // namespace RollingContact
