#include <rolling_contact/analyses/transient.h>
#include <rolling_contact/base/collective_failure.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/result_error.h>
#include <rolling_contact/results/rough_state.h>
#include <rolling_contact/results/state_report.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/time/checkpoint_schedule.h>
#include <rolling_contact/time/cycle_recording.h>
#include <rolling_contact/time/march.h>

#include <cmath>

namespace RollingContact
{
  template <int dim>
  void Transient<dim>::run()
  {
    if (!bodies_touch(scene))
      throw InputError("Analysis = transient needs a patch to make the mesh "
                       "for: give Contact/Approach or Contact/Normal load "
                       "above 0; Time/Approach gives the motion in time.");
    Checkpoint start;
    if (context.resume)
      start = read_checkpoint(context.folder);
    PairDemands demands;
    demands.displacements = scene.inputs->output.body_fields;
    ContactStepper<dim> stepper(scene, demands, context);
    const TimeSteps     steps = scene.inputs->time.steps(stepper.drive().speed);
    stepper.set_time_step(steps.length);
    falling.emplace(scene, stepper.current().grading.element_size_x);
    files = files_of(scene);
    if (context.resume)
      {
        refuse_changed_entries(start.tables, files, {});
        stepper.restore(start);
        progress = start.progress;
        context.log.message("Resumed after step " +
                            std::to_string(progress.step) +
                            ", t = " + significant(progress.time, 6) + " s" +
                            (progress.step == steps.number
                               ? ": no step is left, the results stay."
                               : "."));
      }
    describe(stepper, steps);
    if (scene.inputs->time.estimates_step() && !context.resume &&
        Ranks::count() == 1)
      estimate.emplace(scene, steps, stepper, context);
    TransientOutput<dim> output(scene, context, start, stepper);
    try
      {
        take_steps(steps, stepper, output);
      }
    catch (const Interrupted &)
      {
        if (Ranks::all_ranks_failed(ExitCode::not_converged))
          output.write_checkpoint(stepper, progress, files);
        throw;
      }
    catch (const ConvergenceError &)
      {
        if (Ranks::all_ranks_failed(ExitCode::not_converged))
          {
            output.write_fields(stepper, progress, true);
            output.write_checkpoint(stepper, progress, files);
          }
        throw;
      }
    output.write_fields(stepper, progress, true);
    output.write_checkpoint(stepper, progress, files);
    summarise(stepper);
    output.finish(stepper, progress);
    note_error_of_step(scene, stepper.current(), context.report);
    if (estimate)
      if (const auto of_step = estimate->errors(stepper))
        add_error_of_step(*of_step, context.report);
    warn_of_unknown_errors(context);
    if (output.period() > 0.)
      record_cycle(
        scene, progress.time, steps.length, output.period(), stepper, context);
  }

  template <int dim>
  void Transient<dim>::describe(const ContactStepper<dim> &stepper,
                                const TimeSteps           &steps) const
  {
    context.log.message(
      std::to_string(steps.number) + " steps of " +
      significant(steps.length, 4) + " s, " +
      (scene.inputs->time.inertia
         ? "theta = " + significant(scene.inputs->time.theta, 4)
         : std::string("without inertia")) +
      ", " + std::to_string(stepper.current().problem.n_nodes()) +
      " contact nodes.");
    if (scene.inputs->time.inertia && scene.inputs->time.damping_frequency > 0.)
      context.log.message(
        "Numerical damping at " +
        significant(scene.inputs->time.damping_frequency, 4) + " Hz: zeta = " +
        scientific(scene.inputs->time.numerical_damping(steps.length), 3) +
        ".");
    if (scene.inputs->has_reduced_bodies())
      {
        const double f = scene.inputs->modes.maximum_frequency,
                     x = pi * f * steps.length; // trapezoidal rule: atan(x) / x
        context.log.message(
          "Bodies by their modes: steps of this length lower "
          "frequencies by " +
          significant(100 * (1 - std::atan(x) / x), 2) +
          " % at Modes/Maximum frequency = " + significant(f, 5) + " Hz.");
      }
    describe_surfaces(*stepper.current().pair, context);
    warn_of_long_steps(scene,
                       stepper.current(),
                       std::abs(stepper.drive().speed.value(0.)) * steps.length,
                       context);
    if (!scene.inputs->time.inertia)
      describe_factors(stepper.current(), context);
    auto      &objects = context.report.objects;
    const auto memory  = stepper.bodies().memory_consumption();
    const auto add     = [&](const std::string &object,
                         const bool         built,
                         const std::size_t  bytes,
                         const std::string &reason) {
      objects.push_back({object, built, bytes, 0., built ? "" : reason});
    };
    const bool inertia = scene.inputs->time.inertia,
               slips   = stepper.current().problem.n_tangential() > 0;
    add("K, M", inertia, memory.matrices, "Time/Inertia = false");
    add("factor of the step", inertia, memory.solver, "Time/Inertia = false");
    add("columns Y", inertia, memory.columns, "Time/Inertia = false");
    add("compliance W",
        true,
        stepper.current().problem.operators.W().memory_consumption(),
        "");
    add("tangential compliance, B1, B2", slips, 0, "frictionless");
  }

  template <int dim>
  void Transient<dim>::take_steps(const TimeSteps      &steps,
                                  ContactStepper<dim>  &stepper,
                                  TransientOutput<dim> &output)
  {
    const auto review = [&](const StepOutcome &outcome) {
      const SteadyState<dim> &contact = stepper.current();
      if (estimate)
        estimate->add(progress.step, contact.result);
      worst.add(outcome.several,
                contact.problem,
                "t = " + significant(progress.time, 6) + " s");
      if (scene.inputs->time.inertia)
        falling->add(contact.problem, contact.state);
    };
    const auto write = [&](const StepOutcome &outcome) {
      output.add_row(stepper, outcome, progress);
      output.write_fields(stepper, progress, false);
    };
    Progress   display(context.log, "step", steps.number, progress.step);
    const auto show = [&](const StepOutcome &) {
      display.report(progress.step);
    };
    CheckpointSchedule schedule(scene.inputs->time.checkpoint_interval,
                                scene.inputs->time.checkpoint_seconds);
    const Stopwatch    watch;
    const auto         now  = [&]() { return Ranks::maximum(watch.seconds()); };
    const auto         keep = [&](const StepOutcome &) {
      const double begin = now();
      if (!schedule.is_due(progress.step, begin))
        return;
      output.write_checkpoint(stepper, progress, files);
      schedule.written(begin, now());
    };
    march<dim>({steps, 0., progress.step, [&]() { return output.settled(); }},
               stepper,
               progress,
               {review, write, show, keep});
  }

  template <int dim>
  void Transient<dim>::summarise(const ContactStepper<dim> &stepper) const
  {
    if (!stepper.bodies().description().empty())
      context.log.message(stepper.bodies().description() + ".");
    warn_of_non_uniqueness(scene.dimension,
                           scene.inputs->time.inertia
                             ? SolutionsOf::steps_with_inertia
                             : SolutionsOf::steps_without_inertia,
                           worst,
                           context.log);
    if (const std::string complaint = falling->complaint(); !complaint.empty())
      {
        context.log.warning(complaint);
        context.report.set_finding(
          "law",
          "friction falls " + significant(falling->gain(), 3) +
            " times as fast as the bodies radiate waves: no limit for finer "
            "elements");
      }
    context.report.set_finding(
      "end",
      "t = " + significant(progress.time, 6) + " s, rolled " +
        significant(1e3 * progress.rolled_distance, 6) + " mm, " +
        std::to_string(progress.n_impacts) + " impacts of nodes");
    note_state(stepper.current(), context.report);
    tell_rough_state(scene, stepper.current(), context);
    if (const auto velocity = stepper.bodies().wheel_velocity())
      context.report.set_finding(
        "wheel",
        "its centre of mass moves along z at " + significant(*velocity, 6) +
          " m/s" + (*velocity > 0. ? ", away from the rail; " : "; ") +
          significant(scene.inputs->time.initial_velocity, 6) +
          " m/s at the start");
    context.report.set_finding(
      "energy",
      "stored " + significant(stepper.bodies().stored_energy(), 5) +
        " J, supplied " + significant(progress.supplied_energy, 5) +
        " J, friction " + significant(progress.friction_energy, 5) +
        " J, damping " + significant(progress.damping_energy, 5) +
        " J, numerical " + significant(progress.numerical_energy, 5) +
        " J; balance error " + scientific(progress.energy_error, 2) + " J");
  }

  template class Transient<2>;
  template class Transient<3>;
} // namespace RollingContact
