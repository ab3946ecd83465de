#include <fmt/format.h>

#include <rolling_contact/analyses/limit_cycles.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/result_error.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/time/history_rows.h>
#include <rolling_contact/time/limit_cycle.h>
#include <rolling_contact/time/march.h>

#include <algorithm>
#include <limits>

namespace RollingContact
{
  template <int dim>
  LimitCycles<dim>::LimitCycles(const Situation &scene, RunContext &context)
    : scene(scene)
    , section(scene.inputs->own<LimitCycleParameters>())
    , context(context)
  {}

  template <int dim>
  void LimitCycles<dim>::run()
  {
    const auto first = sweep_runs(section, 1).front();
    bodies =
      make_reduced_bodies<dim>(scene_at(first.value), PairDemands(), context);
    modes = std::make_unique<RollingModes<dim>>(
      *bodies.modes,
      *bodies.base.pair,
      bodies.base.problem.operators.W().dense());
    describe_bodies(bodies.base, context);
    note_error_of_step(scene, bodies.base, context.report);
    if (context.resume)
      restore_rows();
    if (state.starts.empty())
      state.starts = find_starts();
    const auto runs = sweep_runs(section, state.starts.size());
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
    note_sweep(section, runs, state.starts, context);
    if (scene.inputs->output.plot)
      plot_sweep(section, runs, context);
    for (std::size_t row = 0; row < runs.size(); ++row)
      if (!end_of_row(context.results, row))
        throw ConvergenceError("Run " + std::to_string(row) +
                               " ended early, see the warning above; column "
                               "cycle of results.csv names all that did.");
  }

  template <int dim>
  void LimitCycles<dim>::restore_rows()
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
    context.results.restore(text.substr(0, end + 1),
                            file,
                            {{"cycle",
                              [](const std::string &name, std::size_t) {
                                return end_named(name);
                              }}});
  }

  template <int dim>
  Situation LimitCycles<dim>::scene_at(const std::optional<double> &value) const
  {
    if (!value)
      return scene;
    SceneEntries entries(scene);
    entries.set(section.axis_entry(), fmt::format("{}", *value));
    entries.check_scene();
    return entries.situation();
  }

  template <int dim>
  typename LimitCycles<dim>::Growing
  LimitCycles<dim>::growing(const Situation &scene) const
  {
    SteadyState<dim> steady = bodies.base;
    {
      PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
      steady.pair->set_loads(scene.contact, steady.problem);
      solve_contact(scene, demands_in_time(PairDemands()), steady);
    }
    if (!steady.solver.converged)
      throw ConvergenceError(
        "The steady state did not converge: " + steady.solver.reason + ".");
    PhaseTimer::Scope phase(context.timer, Phase::eigenvalues);
    const Vibrations  vibrations(
      scene,
      modes->reduced(RollingConditions(scene, scene.inputs->stability)),
      steady.problem,
      steady.state);
    Growing found;
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
  std::vector<double> LimitCycles<dim>::find_starts() const
  {
    if (!section.starts_from_all())
      return section.start_frequencies();
    for (const SweepRun &run : sweep_runs(section, 1))
      {
        const Growing found = growing(scene_at(run.value));
        if (!found.frequencies.empty())
          return found.frequencies;
      }
    throw InputError("Limit cycle/Starts = all: no vibration grows at any "
                     "value; see Analysis = stability.");
  }

  template <int dim>
  bool LimitCycles<dim>::settle(const Situation     &scene,
                                ContactStepper<dim> &stepper,
                                CycleWatch          &watch) const
  {
    const HistoryRows rows(scene);
    TransientProgress progress;
    const auto        look = [&](const StepOutcome &outcome) {
      watch.add_row(rows.names(), rows.row(stepper, outcome, progress));
    };
    try
      {
        march<dim>({scene.inputs->time.steps(stepper.drive().speed),
                    0.,
                    0,
                    [&]() { return watch.settled(); }},
                   stepper,
                   progress,
                   {look});
      }
    catch (const ConvergenceError &error)
      {
        context.log.warning(std::string("A run ended early: ") + error.what());
        return false;
      }
    return true;
  }

  template <int dim>
  void LimitCycles<dim>::take(const SweepRun &run)
  {
    Situation here = scene_at(run.value);
    if (run.first)
      state.carried.reset();
    const Growing found = growing(here);
    if (!state.carried && !found.frequencies.empty())
      {
        SceneParameters excited  = *here.inputs;
        excited.time.excite_mode = state.starts[run.start];
        here                     = Situation(excited, &here);
      }
    const DrivingFunctions histories =
      here.inputs->time.histories(here.contact, here.inputs->prm_folder);
    const double h = here.inputs->time.steps(histories.speed).length;
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
    const bool begins = state.carried || here.inputs->time.excite_mode > 0.;
    const bool solved = !begins || settle(here, stepper, watch);

    ResultsTable &results = context.results;
    results.set("state", state.n_rows);
    results.set("start_Hz", state.starts[run.start]);
    if (run.value)
      results.set(section.axis_entry(), *run.value);
    results.set("direction", run.up ? "up" : "down");
    results.set("n_unstable", found.frequencies.size());
    results.set("largest_growth_1/s", found.largest);
    results.set("steps", watch.n_rows());
    const LimitCycle cycle(watch, stepper.excited());
    cycle.add_columns(results);
    const RunEnd end = !solved  ? RunEnd()
                       : begins ? cycle.motion()
                                : Cycles::Motion::decayed; // at rest
    results.set("cycle", name_of(end), end);
    results.end_row();
    ++state.n_rows;
    state.carried.reset();
    if (end && *end != Cycles::Motion::decayed)
      state.carried = stepper.disturbance();
  }

  template class LimitCycles<2>;
  template class LimitCycles<3>;

  namespace
  {
    void check_limit_cycle(const SceneParameters &scene)
    {
      const std::string     why  = "Analysis = limit cycle: ";
      const TimeParameters &time = scene.time;
      time.check_cycles(
        time.steps(time.histories(scene.contact, scene.prm_folder).speed), why);
      if (scene.contact.slip_operator == SlipOperatorKind::galerkin)
        throw InputError(why + "Contact/Slip operator must be `calibrated`, "
                               "`upwind 2` or `upwind 1`, for which vibrations "
                               "that grow are found.");
      if (time.bodies != BodiesInTime::reduced)
        throw InputError(why + "bodies are reduced once for all runs; take "
                               "Time/Bodies = reduced.");
      if (!(time.excite_velocity > 0.))
        throw InputError(
          why + "Time/Excite velocity = " + text_of(time.excite_velocity) +
          ": it is what each start begins with; give a velocity "
          "above 0 m/s.");
      if (time.excite_mode != 0.)
        throw InputError(why +
                         "Time/Excite mode = " + text_of(time.excite_mode) +
                         ": the starts are those of Limit cycle/Starts; set it "
                         "to 0.");
    }
  } // namespace

  AnalysisKind limit_cycle_kind()
  {
    AnalysisKind kind = kind_of<LimitCycles>(
      "limit cycle",
      "runs in time until the motion repeats itself, from several starts and "
      "along an axis, see sections Time and Limit cycle");
    kind.sections = {"Time", "Limit cycle"};
    kind.own_section.emplace(LimitCycleParameters());
    kind.axes = [](const SceneParameters &scene) -> std::vector<TableAxis> {
      const auto &cycle = scene.own<LimitCycleParameters>();
      if (cycle.axis_entry().empty())
        return {};
      return {{"Limit cycle/Values", cycle.axis_entry(), cycle.axis_values()}};
    };
    kind.marches        = true;
    kind.until_periodic = true;
    kind.on_ranks       = false;
    kind.rules          = {&check_limit_cycle};
    kind.resumption     = [](const Situation &scene) {
      return RunFolder::Resumption{entries_free_on_resume(*scene.inputs),
                                   "limit_cycle_state.txt",
                                   {},
                                   {}};
    };
    return kind;
  }
} // namespace RollingContact
