#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/scene/time_parameters.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::vector<NamedValue<InitialState>> named_initial_states{
      {"rest", InitialState::rest},
      {"steady", InitialState::steady}};
    const std::vector<NamedValue<BodiesInTime>> named_bodies{
      {"full", BodiesInTime::full},
      {"reduced", BodiesInTime::reduced}};
    const std::vector<NamedValue<MassKind>> named_masses{
      {"lumped", MassKind::lumped},
      {"consistent", MassKind::consistent}};
    const std::vector<NamedValue<ContactLaw>> named_contact_laws{
      {"shifted", ContactLaw::shifted},
      {"gap", ContactLaw::gap}};

    /** Where a run that is resumed goes on from where it was. */
    bool in_one_run(const SceneParameters &scene)
    {
      return scene.analysis.records_run;
    }

    const Reader recorded_runs{
      asks<AnalysisTraits>(
        [](const auto &analysis) { return !analysis.has_row_for_each_run(); }),
      "this analysis decides itself when a run ends, and writes one row for "
      "each run"};
    const Reader runs_to_their_end{
      [](const SceneParameters &scene) {
        return scene.analysis.records_run && !scene.looks_for_cycles() &&
               !scene.has_reduced_bodies();
      },
      "Analysis = transient with Time/Bodies = full and Time/Stop when periodic "
      "= false reads it"};
    const Reader runs_until_periodic{[](const SceneParameters &scene) {
                                       return scene.looks_for_cycles();
                                     },
                                     "Time/Stop when periodic = true reads it"};
  } // namespace

  void TimeParameters::declare(Entries &entries)
  {
    entries.section("Time")
      .read_by({asks<AnalysisTraits, StudyParameters>(
                  [](const auto &analysis, const auto &study) {
                    return !analysis.has_own_meshes || study.varies_time_step;
                  }),
                "Accuracy study/Vary = time step reads that section"})
      .read_by({[](const SceneParameters &scene) { return scene.marches(); },
                "Analysis = transient reads that section"});
    declare_steps(entries);
    declare_start(entries);
    declare_histories(entries);
    declare_output(entries);
  }

  void TimeParameters::declare_steps(Entries &entries)
  {
    entries.add("End time", end_time, "s")
      .at_least(0.)
      .resumed_if(in_one_run)
      .help =
      "Time at which a transient run ends. Give this or `Rolled distance`, 0 "
      "for the other.";
    entries.add("Rolled distance", rolled_distance, "m")
      .at_least(0.)
      .resumed_if(in_one_run)
      .help =
      "Rolled distance at which a transient run ends. It needs a constant "
      "speed.";
    entries.add("Time step", time_step, "s").at_least(0.).help =
      "Length of a step. Give this or `Step length`, 0 for the other.";
    entries.add("Step length", step_length, "m").at_least(0.).help =
      "Distance rolled in one step. It needs a constant speed.";
    entries.add("Maximum halvings", maximum_halvings, "1").between(0, 30).help =
      "How many times in a row a step is halved when its contact solve fails, "
      "before the run stops.";
    entries.add("Step estimate", step_estimate)
      .read_by(runs_to_their_end)
      .resumed_if(in_one_run)
      .help =
      "Whether the run is repeated without output and with steps of twice the "
      "length, to estimate the error that the step length makes in the force "
      "at its end. That costs about half of the run. A resumed run and one on "
      "several ranks are not repeated.";
    entries.add("Theta", theta, "1").between(0.5, 1.).help =
      "Parameter of the theta-scheme: 0.5 keeps the energy, 1 damps most.";
    entries.choice("Bodies", bodies, named_bodies).help =
      "`full`: all unknowns of the bodies. `reduced`: their modes up to "
      "Modes/Cut-off ratio times Modes/Maximum frequency, and the static "
      "compliance that these modes leave out.";
    entries.add("Inertia", inertia).help =
      "Whether the bodies have mass; false: quasi-static rolling in time.";
    entries.choice("Mass", mass, named_masses).help =
      "Mass matrix: `lumped` or `consistent`.";
    entries.add("Rayleigh alpha", rayleigh_alpha, "1/s").at_least(0.).help =
      "Damping C = alpha M + beta K.";
    entries.add("Rayleigh beta", rayleigh_beta, "s").at_least(0.).help =
      "Damping C = alpha M + beta K.";
    entries.choice("Contact law", contact_law, named_contact_laws).help =
      "Unilateral contact in time: `shifted` (gap of Jean's shifted "
      "configuration) or `gap` (gap plus step times velocity).";
  }

  void TimeParameters::declare_start(Entries &entries)
  {
    entries.choice("Initial state", initial_state, named_initial_states).help =
      "`rest`: undeformed and without traction; `steady`: the steady rolling "
      "state at t = 0.";
    entries.add("Hold approach", hold_approach).help =
      "Whether Contact/Normal load gives the steady initial state only, whose "
      "approach is then kept during the run.";
    entries.add("Excite mode", excite_mode, "Hz").at_least(0.).help =
      "With Bodies = reduced the run starts in a vibration about the steady "
      "state: the one nearest to this frequency of those that grow, or of all "
      "if none grows, see Analysis = stability. 0: no vibration.";
    entries.add("Excite velocity", excite_velocity, "m/s").at_least(0.).help =
      "Largest velocity of wheel over rail in the contact at the start, for "
      "the vibration of `Excite mode`.";
    entries.add("Initial velocity", initial_velocity, "m/s").help =
      "Velocity along z of a wheel with Hub = free or mass at the start; "
      "negative towards the rail.";
  }

  void TimeParameters::declare_histories(Entries &entries)
  {
    const std::string forms =
      ": a number, an expression in t (s), `FILE.csv` or `table: FILE column` "
      "(time in s first; file relative to the .prm file). Empty: as in "
      "section Contact.";
    const std::string instead =
      " on the wheel over time, in place of the creepage, which is found for "
      "it" +
      forms;
    entries.add("Approach", approach, "m").help =
      "Approach over time" + forms +
      " Give Contact/Approach too, because the mesh is made for it.";
    entries.add("Normal load", normal_load, "N").help =
      "Normal load over time" + forms +
      " Give Contact/Normal load too, because the mesh is made for it.";
    entries.add("Creepage x", creepage_x, "1").help =
      "Longitudinal creepage over time" + forms;
    entries.add("Creepage y", creepage_y, "1").help =
      "Lateral creepage over time, 3D only" + forms;
    entries.add("Spin", spin, "1/m").help =
      "Spin creepage over time, 3D only" + forms;
    entries.add("Longitudinal force", longitudinal_force, "N").help =
      "Force of friction along x" + instead;
    entries.add("Lateral force", lateral_force, "N").help =
      "Force of friction along y, 3D only," + instead;
    entries.add("Spin moment", spin_moment, "N m").help =
      "Moment of friction about the normal, 3D only," + instead;
    entries.add("Speed", speed, "m/s").help =
      "Rolling speed over time, with the sign of Contact/Speed" + forms;
  }

  void TimeParameters::declare_output(Entries &entries)
  {
    entries.add("Field interval", field_interval, "1")
      .at_least(0)
      .read_by(recorded_runs)
      .help = "Number of steps from one writing of fields to the next; 0: no "
              "fields.";
    entries.add("Checkpoint interval", checkpoint_interval, "1")
      .read_by(recorded_runs)
      .resumed_if(in_one_run)
      .at_least(0)
      .help =
      "Number of steps from one checkpoint for --resume to the next; 0: by "
      "`Checkpoint seconds`.";
    entries.add("Checkpoint seconds", checkpoint_seconds, "s")
      .read_by(recorded_runs)
      .resumed_if(in_one_run)
      .at_least(0.)
      .help =
      "Wall time from one checkpoint to the next. The first ones come sooner; "
      "checkpoints come later where they would take more than 3 % of the "
      "time. 0: by `Checkpoint interval`.";
    entries.add("Damping frequency", damping_frequency, "Hz")
      .at_least(0.)
      .help =
      "Frequency f for which the run reports the numerical damping (theta - "
      "1/2) 2 pi f dt; 0: none.";
    entries.add("Stop when periodic", stop_when_periodic)
      .read_by(recorded_runs)
      .resumed_if(in_one_run)
      .help =
      "Whether the run ends before `End time` when the motion repeats itself "
      "or nothing moves any more. Its limit cycle is measured then: "
      "cycle.csv, cycle.svg, cycle_patch.csv.";
    entries.add("Periodic tolerance", periodic_tolerance, "1")
      .between(1e-6, 0.1)
      .read_by(runs_until_periodic)
      .resumed_if(in_one_run)
      .help =
      "Largest difference of a period from those before it, as a share of the "
      "range of each velocity and force. The amplitude may still be off its "
      "final value by this share.";
    entries.add("Periodic after", periodic_after, "s")
      .at_least(0.)
      .read_by(runs_until_periodic)
      .resumed_if(in_one_run)
      .help =
      "Time at the beginning of the run that is left out when periods are "
      "looked for.";
  }

  namespace
  {
    void require_constant(const TimeFunction &speed,
                          const std::string  &entry,
                          const double        value,
                          const std::string  &instead)
    {
      if (!speed.is_constant() || speed.value(0.) == 0.)
        throw InputError("Time/" + entry + " = " + text_of(value) +
                         ": it needs a constant speed other than 0; give "
                         "Time/" +
                         instead + '.');
    }
  } // namespace

  DrivingFunctions
  TimeParameters::histories(const ContactParameters     &contact,
                            const std::filesystem::path &prm_folder) const
  {
    PrmEntries tables;
    const auto read = [&](const std::string &name,
                          const std::string &text,
                          const double       constant) {
      const std::string  entry   = "Time/" + name;
      const TimeFunction history = text.empty()
                                     ? TimeFunction(constant)
                                     : TimeFunction(entry, text, prm_folder);
      if (history.is_table())
        tables[entry + " (table)"] = history.table_fingerprint();
      return history;
    };
    DrivingFunctions driving{
      {},
      {},
      read("Creepage x", creepage_x, contact.creepages.x),
      read("Creepage y", creepage_y, contact.creepages.y),
      read("Spin", spin, contact.creepages.spin),
      read("Speed", speed, contact.rolling_speed()),
      {},
      {},
      {},
      {}};
    const auto ask = [&](const std::string          &name,
                         const std::string          &text,
                         const std::optional<double> constant) {
      return text.empty() && !constant
               ? std::optional<TimeFunction>()
               : read(name, text, constant.value_or(0.));
    };
    driving.longitudinal_force =
      ask("Longitudinal force", longitudinal_force, contact.forces.x);
    driving.lateral_force =
      ask("Lateral force", lateral_force, contact.forces.y);
    driving.spin_moment =
      ask("Spin moment", spin_moment, contact.forces.moment);
    if (const auto load = contact.normal_load)
      driving.normal_load = read("Normal load", normal_load, *load);
    if (const auto depth = contact.approach)
      driving.approach = read("Approach", approach, *depth);
    driving.tables = tables;
    return driving;
  }

  TimeSteps TimeParameters::steps(const TimeFunction &speed) const
  {
    TimeSteps result{time_step, 0};
    double    end = end_time;
    if (step_length > 0.)
      {
        require_constant(speed, "Step length", step_length, "Time step");
        result.length = step_length / std::abs(speed.value(0.));
      }
    if (rolled_distance > 0.)
      {
        require_constant(speed, "Rolled distance", rolled_distance, "End time");
        end = rolled_distance / std::abs(speed.value(0.));
      }
    // A quotient that is whole but for rounding takes no step more.
    const double number = std::ceil(end / result.length * (1 - 1e-12));
    if (!(number <= 1e12))
      throw InputError("Section Time asks for " + significant(number, 3) +
                       " steps: at most 1e12 are possible, take longer ones.");
    result.number = static_cast<std::uint64_t>(number);
    return result;
  }

  double TimeParameters::numerical_damping(const double step) const
  {
    return (theta - 0.5) * 2 * numbers::PI * damping_frequency * step;
  }
} // namespace RollingContact
