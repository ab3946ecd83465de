#include <fmt/format.h>

#include <rolling_contact/analyses/limit_cycles.h>
#include <rolling_contact/assessment/result_error.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/histories/history_rows.h>
#include <rolling_contact/histories/limit_cycle.h>
#include <rolling_contact/parallel/interrupt.h>
#include <rolling_contact/report/bodies_report.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/scene/scene_entries.h>

#include <algorithm>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /// in column cycle, a run that did not reach its end
    const std::string not_converged = "not converged";



    StateDemands
    demands()
    {
      StateDemands demands       = demands_in_time(PairDemands());
      demands.pair.displacements = true; // keeps the factors
      demands.pair.factors       = true;
      return demands;
    }
  } // namespace



  template <int dim>
  LimitCycles<dim>::LimitCycles(const SceneParameters &scene,
                                RunContext            &context)
    : scene(scene)
    , context(context)
  {}



  template <int dim>
  void
  LimitCycles<dim>::run()
  {
    const auto first = sweep_runs(scene.limit_cycle, 1).front();
    bodies =
      make_reduced_bodies<dim>(scene_at(first.value), demands(), context);
    modes =
      std::make_unique<RollingModes<dim>>(*bodies.modes,
                                          *bodies.base.pair,
                                          bodies.base.problem.operators.W());
    describe_bodies(bodies.base, context);
    note_error_of_step(scene, bodies.base, context.report);
    if (context.resume)
      restore_rows();
    if (state.starts.empty())
      state.starts = find_starts();
    const auto runs = sweep_runs(scene.limit_cycle, state.starts.size());
    context.log.message(
      std::to_string(state.starts.size()) +
      (state.starts.size() == 1 ? " start, " : " starts, ") +
      std::to_string(runs.size()) + (runs.size() == 1 ? " run" : " runs") +
      (state.n_rows > 0
         ? ", " + std::to_string(state.n_rows) + " of them are there already."
         : "."));
    Progress display(context.log, "run", runs.size(), state.n_rows);
    while (state.n_rows < runs.size())
      {
        throw_if_interrupted();
        take(runs[state.n_rows]);
        context.results.flush();
        write_sweep_state(state, context.folder);
        display.report(state.n_rows);
      }
    note_sweep(scene.limit_cycle, runs, state.starts, context);
    if (scene.output.plot)
      plot_sweep(scene.limit_cycle, runs, context);
    for (std::size_t row = 0; row < runs.size(); ++row)
      if (context.results.text(row, "cycle") == not_converged)
        throw ConvergenceError("Run " + std::to_string(row) +
                               " ended early, see the warning above; column "
                               "cycle of results.csv names all that did.");
  }



  template <int dim>
  void
  LimitCycles<dim>::restore_rows()
  {
    state           = read_sweep_state(context.folder);
    const auto file = (context.folder.get_path() / "results.csv").string();
    // a row whose state was not written is taken again
    std::string text = read_bytes(file);
    std::size_t end  = text.find('\n');
    for (std::size_t k = 0; k < state.n_rows && end != std::string::npos; ++k)
      end = text.find('\n', end + 1);
    if (end == std::string::npos)
      throw InputError("Cannot resume: \"" + file + "\" has less than " +
                       std::to_string(state.n_rows) +
                       " rows. Start the run without --resume.");
    context.results.restore(text.substr(0, end + 1), file);
  }



  template <int dim>
  SceneParameters
  LimitCycles<dim>::scene_at(const std::optional<double> &value) const
  {
    if (!value)
      return scene;
    SceneEntries entries(scene);
    entries.set(scene.limit_cycle.axis_entry(), fmt::format("{}", *value));
    return entries.scene();
  }



  template <int dim>
  typename LimitCycles<dim>::Growing
  LimitCycles<dim>::growing(const SceneParameters &scene) const
  {
    SteadyState<dim> steady = bodies.base;
    {
      PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
      steady.pair->set_loads(scene.contact, steady.problem);
      solve_contact(scene, demands(), steady);
    }
    if (!steady.solver.converged)
      throw ConvergenceError(
        "The steady state did not converge: " + steady.solver.reason + ".");
    PhaseTimer::Scope phase(context.timer, Phase::eigenvalues);
    const Vibrations  vibrations(scene,
                                modes->reduced(RollingConditions(scene)),
                                steady.problem,
                                steady.state);
    Growing           found;
    found.largest = -std::numeric_limits<double>::infinity();
    for (const auto &s : vibrations.least_damped(1))
      {
        if (s.real() > 0.)
          found.frequencies.push_back(s.imag() / (2 * pi));
        found.largest = std::max(found.largest, s.real());
      }
    return found;
  }



  template <int dim>
  std::vector<double>
  LimitCycles<dim>::find_starts() const
  {
    if (!scene.limit_cycle.starts_from_all())
      return scene.limit_cycle.start_frequencies();
    for (const SweepRun &run : sweep_runs(scene.limit_cycle, 1))
      {
        const Growing found = growing(scene_at(run.value));
        if (!found.frequencies.empty())
          return found.frequencies;
      }
    throw InputError("Limit cycle/Starts = all: no vibration grows at any "
                     "value; see Analysis = stability.");
  }



  template <int dim>
  bool
  LimitCycles<dim>::march(const SceneParameters &scene,
                          ContactStepper<dim>   &stepper,
                          CycleWatch            &watch) const
  {
    const TimeSteps   steps = scene.time.steps(stepper.drive().speed);
    const HistoryRows rows(scene);
    TransientProgress progress;
    stepper.set_time_step(steps.length);
    try
      {
        while (progress.step < steps.number && !watch.settled())
          {
            throw_if_interrupted();
            const StepOutcome outcome =
              stepper.advance(progress.time, steps.length);
            add_step(progress, outcome, steps.length);
            progress.time = progress.step * steps.length;
            watch.add_row(rows.names(), rows.row(stepper, outcome, progress));
          }
      }
    catch (const ConvergenceError &error)
      {
        context.log.warning(std::string("A run ended early: ") + error.what());
        return false;
      }
    return true;
  }



  template <int dim>
  void
  LimitCycles<dim>::take(const SweepRun &run)
  {
    SceneParameters here = scene_at(run.value);
    if (run.first)
      state.carried.reset();
    const Growing found = growing(here);
    if (!state.carried && !found.frequencies.empty())
      here.time.excite_mode = state.starts[run.start];
    const DrivingFunctions histories =
      here.time.histories(here.contact, here.prm_folder);
    const double h = here.time.steps(histories.speed).length;
    ResultsTable row;
    RunReport    report;
    RunContext   own{context.folder, row, report, context.timer, context.log};
    CycleWatch   watch(here, h);
    ContactStepper<dim> stepper(here,
                                make_reduced_contact(here,
                                                     bodies,
                                                     histories,
                                                     h,
                                                     state.carried
                                                       ? &*state.carried
                                                       : nullptr,
                                                     own),
                                own);
    const bool          begins = state.carried || here.time.excite_mode > 0.;
    const bool          solved = !begins || march(here, stepper, watch);

    ResultsTable &results = context.results;
    results.set("state", state.n_rows);
    results.set("start_Hz", state.starts[run.start]);
    if (run.value)
      results.set(scene.limit_cycle.axis_entry(), *run.value);
    results.set("direction", run.up ? "up" : "down");
    results.set("n_unstable", found.frequencies.size());
    results.set("largest_growth_1/s", found.largest);
    results.set("steps", watch.n_rows());
    const LimitCycle cycle(watch, stepper.excited());
    cycle.add_columns(results);
    if (!solved)
      results.set("cycle", not_converged);
    else if (!begins) // at rest in a stable state
      results.set("cycle", "decayed");
    results.end_row();
    ++state.n_rows;
    const std::string came_to = results.text(state.n_rows - 1, "cycle");
    state.carried.reset();
    if (solved && begins && came_to != "decayed")
      state.carried = stepper.disturbance();
  }



  template class LimitCycles<2>;
  template class LimitCycles<3>;
} // namespace RollingContact
