#include <rolling_contact/analyses/error_cost_report.h>
#include <rolling_contact/analyses/time_study.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/time/march.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  template <int dim>
  void TimeStudy<dim>::run()
  {
    if (!bodies_touch(scene))
      throw InputError("Accuracy study/Vary = time step needs a patch to make "
                       "the mesh for: give Contact/Approach or Contact/Normal "
                       "load above 0.");
    const StudyParameters &study  = scene.inputs->study;
    const double           finest = study.reference_time_step;
    context.log.message(
      std::to_string(2 + study.thetas.size() * study.time_steps.size()) +
      " runs, the two of the reference first.");
    const Run coarse = solve(2 * finest, study.thetas.front());
    const Run fine   = solve(finest, study.thetas.front());
    for (const Run *reference : {&coarse, &fine})
      if (!reference->failure.empty())
        throw ConvergenceError("Accuracy study, the reference: " +
                               reference->failure);
    const bool second_order =
      !scene.inputs->time.inertia || study.thetas.front() == 0.5;
    const ForceHistory limit =
      limit_of(coarse.history, fine.history, second_order ? 2. : 1.);
    if (limit.forces.empty())
      throw InputError(
        "Accuracy study/Reference time step = " + significant(finest, 6) +
        " s: the run ends within two such steps.");
    std::vector<double> steps = study.time_steps;
    std::sort(steps.begin(), steps.end(), std::greater<>());
    std::vector<Run> runs;
    for (const double theta : study.thetas)
      for (const double step : steps)
        runs.push_back(solve(step, theta));
    context.log.message(
      std::string("Histories against the limit of ") +
      (second_order ? "second" : "first") + " order of the steps " +
      significant(finest, 4) + " and " + significant(2 * finest, 4) +
      " s with theta = " + significant(study.thetas.front(), 4) +
      ", which is " +
      scientific(judged(history_errors(coarse.history, limit)), 2) +
      " from the larger of them. Errors over " +
      (scene.contact.friction_coefficient > 0. ? "mu N" : "N") +
      ", largest over time:");
    report(runs, limit);
  }

  template <int dim>
  double TimeStudy<dim>::judged(const HistoryErrors &errors) const
  {
    const double mu = scene.contact.friction_coefficient;
    return mu > 0. ? errors.force_largest / mu : errors.load_largest;
  }

  template <int dim>
  typename TimeStudy<dim>::Run TimeStudy<dim>::solve(const double step,
                                                     const double theta)
  {
    Run run;
    run.step         = step;
    run.theta        = theta;
    run.history.step = step;
    run.history.lag  = scene.inputs->time.inertia ? (1 - theta) * step : 0.;

    SceneParameters inputs  = *scene.inputs;
    inputs.time.step_length = 0.;
    inputs.time.time_step   = step;
    inputs.time.theta       = theta;
    const Situation varied(inputs, &scene);
    release_free_memory();
    reset_peak_memory();
    try
      {
        take_steps(varied, run);
      }
    catch (const ConvergenceError &error)
      {
        run.failure = error.what();
        context.log.warning("Time step " + significant(step, 4) +
                            " s, theta = " + significant(theta, 4) + ": " +
                            run.failure);
      }
    run.peak_memory = peak_memory_since_reset();
    return run;
  }

  template <int dim>
  void TimeStudy<dim>::take_steps(const Situation &varied, Run &run)
  {
    const auto cpu_seconds = [&]() {
      return PhaseTimer::total(context.timer.rows()).cpu_seconds;
    };
    const double begin = cpu_seconds();
    Log          quiet(Verbosity::quiet);
    RunContext   unheard{
      context.folder, context.results, context.report, context.timer, quiet};
    PairDemands demands;
    demands.factors = true;
    ContactStepper<dim> stepper(varied, demands, unheard);
    const TimeSteps steps = varied.inputs->time.steps(stepper.drive().speed);
    stepper.set_time_step(steps.length);
    run.set_up_s = cpu_seconds() - begin;
    Progress          display(context.log,
                     "step of " + significant(run.step, 4) + " s",
                     steps.number);
    TransientProgress progress;
    const auto        keep = [&](const StepOutcome &outcome) {
      const Resultants &result = stepper.current().result;
      run.history.forces.push_back(
        {{result.force_x, result.force_y, result.normal_force}});
      run.iterations += double(outcome.solver.iterations) / steps.number;
      display.report(progress.step);
    };
    march<dim>({steps}, stepper, progress, {keep});
    run.steps_s = cpu_seconds() - begin - run.set_up_s;
    context.results.set("time_step_s", run.step);
    context.results.set("theta", run.theta);
    context.results.set("time_s", steps.number * steps.length);
    add_result_row(varied, stepper.current(), context);
    context.log.message("step " + significant(run.step, 4) +
                        " s, theta = " + significant(run.theta, 4) + ": " +
                        std::to_string(steps.number) + " steps");
  }

  template <int dim>
  void TimeStudy<dim>::add_row(const Run           &run,
                               const HistoryErrors &errors,
                               ResultsTable        &table)
  {
    const double mu = scene.contact.friction_coefficient;
    table.set("theta", run.theta);
    table.set("time_step_s", run.step);
    table.set("steps", run.history.forces.size());
    table.set("converged", run.failure.empty());
    if (run.failure.empty() && mu > 0.)
      {
        table.set("force_error_max", errors.force_largest / mu);
        table.set("force_error_mean", errors.force_mean / mu);
      }
    if (run.failure.empty())
      {
        table.set("load_error_max", errors.load_largest);
        table.set("load_error_mean", errors.load_mean);
        table.set("common_times", errors.n_times);
      }
    table.set("iterations_per_step", run.iterations);
    table.set("cpu_set_up_s", run.set_up_s);
    table.set("cpu_steps_s", run.steps_s);
    table.set("cpu_s", run.set_up_s + run.steps_s);
    table.set("peak_memory_bytes", run.peak_memory);
    table.end_row();
  }

  template <int dim>
  void TimeStudy<dim>::report(const std::vector<Run> &runs,
                              const ForceHistory     &reference)
  {
    ResultsTable                          table(context.folder, "summary.csv");
    std::vector<CostedError>              points;
    std::vector<std::vector<std::string>> rows{
      {"", "step (s)", "steps", "error", "order", "set-up (s)", "steps (s)"}};
    double coarser = 0.; // the step before
    for (const Run &run : runs)
      {
        const HistoryErrors errors = history_errors(run.history, reference);
        add_row(run, errors, table);
        const bool        failed = !run.failure.empty();
        const std::string method = "theta = " + significant(run.theta, 4);
        const double      error =
          failed ? std::numeric_limits<double>::quiet_NaN() : judged(errors);
        const bool has_coarser =
          !points.empty() && points.back().method == method;
        const double order = has_coarser
                               ? std::log(points.back().error / error) /
                                   std::log(coarser / run.step)
                               : 0.;
        points.push_back({method,
                          significant(run.step, 4) + " s",
                          run.set_up_s + run.steps_s,
                          error});
        rows.push_back({method,
                        significant(run.step, 4),
                        std::to_string(run.history.forces.size()),
                        failed ? "failed" : scientific(error, 2),
                        has_coarser ? significant(order, 2) : "-",
                        significant(run.set_up_s, 2),
                        significant(run.steps_s, 2)});
        coarser = run.step;
      }
    table.flush();
    context.log.message(aligned_table(rows));
    const bool friction = scene.contact.friction_coefficient > 0.;
    report_errors_and_costs({{"all", points}},
                            friction ? "largest error of T / (\u03bcN)"
                                     : "largest error of the load / N",
                            "run",
                            context);
    note_study_error(points,
                     friction ? "force" : "load",
                     friction ? "mu N" : "N",
                     "the steps extrapolated",
                     context.report);
  }

  template class TimeStudy<2>;
  template class TimeStudy<3>;
} // namespace RollingContact
