#include <rolling_contact/analyses/impacts.h>
#include <rolling_contact/analyses/step_estimate.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/results/bodies_report.h>
#include <rolling_contact/results/rough_state.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/scene/time_function.h>
#include <rolling_contact/surfaces/dent.h>
#include <rolling_contact/time/march.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  void ImpactParameters::declare(Entries &entries)
  {
    entries.section("Impact").read_by_analyses("impact");
    entries.add("Speeds", speeds, "m/s").help =
      "Rolling speeds, each with a run of section Time, " +
      std::string(number_list_form) +
      "; all in the direction of Contact/Speed. Empty: Contact/Speed alone.";
  }

  void ImpactParameters::check() const
  {
    speeds_or(1.);
  }

  std::vector<double> ImpactParameters::speeds_or(const double given) const
  {
    return RollingContact::speeds_or(given, "Impact/Speeds", speeds);
  }

  namespace
  {
    ImpactStep step_of(const Resultants &now)
    {
      ImpactStep step;
      step.load     = now.normal_force;
      step.pressure = now.max_pressure;
      return step;
    }

    /// times the largest difference, by which steps may be off: of 80 random
    /// runs all were within 0.72 of what this gives
    const double safety = 1.5;

    /**
     * Largest difference of a run and one with longer steps, up to where both
     * have had their largest value: what comes later changes that no more. The
     * largest values themselves may agree by chance.
     */
    double largest_difference(const std::vector<ImpactStep> &run,
                              const std::vector<ImpactStep> &longer,
                              double ImpactStep::*const value)
    {
      double     end       = 0.;
      const auto find_last = [&](const std::vector<ImpactStep> &steps) {
        const auto largest =
          std::max_element(steps.begin(),
                           steps.end(),
                           [&](const ImpactStep &a, const ImpactStep &b) {
                             return a.*value < b.*value;
                           });
        end = std::max(end, largest->time);
      };
      find_last(run);
      find_last(longer);
      std::vector<std::pair<double, double>> points;
      for (const ImpactStep &step : run)
        points.emplace_back(step.time, step.*value);
      const TimeFunction between("the run", points);
      double             largest = 0.;
      for (const ImpactStep &step : longer)
        if (step.time <= end)
          largest =
            std::max(largest, std::abs(between.value(step.time) - step.*value));
      return largest;
    }
  } // namespace

  template <int dim>
  Impacts<dim>::Impacts(const Situation &scene, RunContext &context)
    : scene(scene)
    , context(context)
    , speeds(scene.inputs->own<ImpactParameters>().speeds_or(
        std::abs(scene.contact.rolling_speed())))
  {}

  template <int dim>
  Situation Impacts<dim>::scene_at(const double speed) const
  {
    SceneEntries entries(scene);
    entries.set("Contact/Speed", text_of(scene.contact.flow() * speed));
    entries.check_scene();
    return entries.situation();
  }

  template <int dim>
  void Impacts<dim>::warn_of_edges() const
  {
    for (const Side side : both_sides)
      {
        const std::string entry  = SurfaceParameters::entry(side),
                          height = scene.surfaces.height[side];
        const auto dent          = dent_named(entry, height);
        if (dent && dent->kind == Dent::Kind::flat)
          context.log.warning(
            entry + " = " + height +
            ": pressures on the edges of a fresh flat grow without limit as "
            "elements become finer, so that largest_pressure_Pa holds for "
            "this mesh only. Edges soon become round; take dip : LENGTH, "
            "DEPTH.");
      }
  }

  template <int dim>
  void Impacts<dim>::run()
  {
    if (!bodies_touch(scene))
      throw InputError("Analysis = impact needs bodies that touch: give "
                       "Contact/Approach or Contact/Normal load above 0.");
    bodies = make_reduced_bodies<dim>(scene_at(speeds.front()),
                                      PairDemands(),
                                      context);
    describe_bodies(bodies.base, context);
    warn_of_edges();
    context.log.message(std::to_string(speeds.size()) +
                        (speeds.size() == 1 ? " speed." : " speeds."));
    std::vector<Impact> impacts;
    Progress            display(context.log, "speed", speeds.size(), 0);
    for (const double speed : speeds)
      {
        throw_if_interrupted();
        impacts.push_back(impact_at(speed));
        add_row(impacts.back(), context.results);
        context.results.flush();
        display.report(impacts.size());
      }
    context.log.message(context.results.screen_table({"speed_m/s",
                                                      "largest_load/at_rest",
                                                      "largest_load_error_N",
                                                      "parted_s",
                                                      "largest_pressure/"
                                                      "at_rest"}));
    note_impacts(impacts, context);
    write_history(worst_of(impacts), HistoryRows(scene).names(), context);
    if (scene.inputs->output.plot)
      plot_impacts(impacts, context);
  }

  template <int dim>
  Impact Impacts<dim>::impact_at(const double speed) const
  {
    const Situation        here = scene_at(speed);
    const DrivingFunctions histories =
      here.inputs->time.histories(here.contact, here.inputs->prm_folder);
    const TimeSteps steps = here.inputs->time.steps(histories.speed);
    ResultsTable    row;
    RunReport       report;
    RunContext own{context.folder, row, report, context.timer, context.log};
    ContactStepper<dim> stepper(
      here,
      make_reduced_contact(here, bodies, histories, steps.length, nullptr, own),
      own);
    warn_of_long_steps(here, stepper.current(), speed * steps.length, context);
    Impact impact;
    impact.speed   = speed;
    impact.step    = steps.length;
    impact.n_steps = steps.number;
    impact.at_rest =
      step_of(resultants(stepper.current().problem, stepper.current().state));
    Checkpoint start;
    stepper.save(start);
    const HistoryRows columns(here);
    impact.run = march_over(steps, columns, stepper);
    estimate(steps, columns, start, stepper, impact);
    return impact;
  }

  template <int dim>
  ImpactRun Impacts<dim>::march_over(const TimeSteps     &steps,
                                     const HistoryRows   &columns,
                                     ContactStepper<dim> &stepper) const
  {
    ImpactRun         found;
    TransientProgress progress;
    stepper.set_time_step(steps.length);
    march<dim>({steps}, stepper, progress, {[&](const StepOutcome &outcome) {
                 ImpactStep now = step_of(stepper.current().result);
                 now.time       = progress.time - outcome.force_lag;
                 now.rolled     = progress.rolled_distance;
                 found.steps.push_back(now);
                 found.rows.push_back(columns.row(stepper, outcome, progress));
               }});
    return found;
  }

  template <int dim>
  void Impacts<dim>::estimate(const TimeSteps     &steps,
                              const HistoryRows   &columns,
                              const Checkpoint    &start,
                              ContactStepper<dim> &stepper,
                              Impact              &impact) const
  {
    const PhaseTimer::Scope phase(context.timer, Phase::step_estimate);
    const TimeSteps         longer = steps_of_twice_the_length(steps);
    try
      {
        stepper.restore(start);
        const auto   other = march_over(longer, columns, stepper).steps;
        const double share = safety / (longer.length / steps.length - 1);
        impact.load_error =
          share *
          largest_difference(impact.run.steps, other, &ImpactStep::load);
        impact.pressure_error =
          share *
          largest_difference(impact.run.steps, other, &ImpactStep::pressure);
      }
    catch (const ConvergenceError &failure)
      {
        context.log.warning("The error of the steps at " +
                            significant(impact.speed, 3) +
                            " m/s is not known, as steps of twice the length "
                            "fail: " +
                            failure.what());
      }
  }

  template class Impacts<2>;
  template class Impacts<3>;

  namespace
  {
    void check_rules(const Situation &scene)
    {
      const std::string     why  = "Analysis = impact: ";
      const TimeParameters &time = scene.inputs->time;
      if (!scene.surfaces.in_use())
        throw InputError(why + "Surfaces/Wheel height and Rail height are "
                               "empty, and a wheel on smooth surfaces hits "
                               "nothing; give a flat, a dip, an expression or "
                               "a record.");
      if (time.bodies != BodiesInTime::reduced)
        throw InputError(why + "bodies are reduced once for all speeds; take "
                               "Time/Bodies = reduced.");
      if (scene.inputs->contact.normal_load && !time.hold_approach)
        throw InputError(why + "with Contact/Normal load the load stays what "
                               "it is; set Time/Hold approach = true, which "
                               "uses it for the start only.");
      if (!time.normal_load.empty() || !time.approach.empty())
        throw InputError(why + "Time/Normal load and Approach would move the "
                               "wheel in addition to the surfaces; leave them "
                               "empty.");
      const double fastest =
        scene.inputs->own<ImpactParameters>()
          .speeds_or(std::abs(scene.contact.rolling_speed()))
          .back();
      const TimeSteps steps = time.steps(TimeFunction(fastest));
      if (steps.number < fewest_steps)
        throw InputError(why + "a run at " + significant(fastest, 3) +
                         " m/s has " + std::to_string(steps.number) +
                         " steps of " + significant(steps.length, 4) +
                         " s, too few for runs with longer steps that tell "
                         "its error; take a shorter Time/Time step or Step "
                         "length.");
      if (scene.mesh.adaptive_levels > 0 || scene.mesh.target_error)
        throw InputError(why + "Mesh/Adaptive levels and Target error are not "
                               "for it; give Mesh/Elements across patch.");
    }

    /** Runs begin before a dent and end behind its middle. */
    void check_way(const Situation &scene)
    {
      const SurfaceSpec &surfaces = scene.surfaces;
      for (const Side side : both_sides)
        {
          const std::string entry = SurfaceParameters::entry(side);
          const auto        dent  = dent_named(entry, surfaces.height[side]);
          if (!dent)
            continue;
          const std::string given  = entry + " = " + surfaces.height[side];
          const double      before = dent->length; // of eight elements or more
          if (std::abs(surfaces.position) < before)
            throw InputError(
              "Surfaces/Position = " + text_of(surfaces.position) + ": " +
              given +
              " is under the wheel at the start, where the load must be that "
              "at rest; begin before it, at a Position of -" +
              significant(before, 3) + " m or less.");
          if (surfaces.position < 0. && surfaces.most_rolled < 0.)
            throw InputError("Time/Rolled distance or End time: runs end " +
                             significant(-surfaces.most_rolled, 3) +
                             " m before the middle of " + given +
                             "; let them roll over it, and farther.");
        }
    }

    void check_impact(const Situation &scene)
    {
      check_rules(scene);
      check_way(scene);
    }
  } // namespace

  AnalysisKind impact_kind()
  {
    AnalysisKind kind = kind_of<Impacts>(
      "impact",
      "the largest load and pressure over the speed as a wheel runs over a "
      "flat, a dip or any other surface, see sections Time and Impact");
    kind.sections = {"Time", "Impact"};
    kind.own_section.emplace(ImpactParameters());
    kind.axes = [](const auto &scene) -> std::vector<TableAxis> {
      const auto &section = scene.template own<ImpactParameters>();
      if (section.speeds.empty())
        return {};
      return {{"Impact/Speeds", "Contact/Speed", section.speeds_or(1.)}};
    };
    kind.marches         = true;
    kind.on_ranks        = false;
    kind.check_situation = &check_impact;
    return kind;
  }
} // namespace RollingContact
