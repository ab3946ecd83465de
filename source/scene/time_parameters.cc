#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_declarations.h>
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
  } // namespace



  void
  TimeParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    declare_steps(prm);
    declare_scheme(prm);
    declare_start(prm);
    declare_histories(prm);
    declare_output(prm);
    declare_end(prm);
    prm.leave_subsection();
  }



  void
  TimeParameters::declare_steps(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.add_parameter(
      "End time",
      end_time,
      "Time at which a transient run ends. Give this or `Rolled "
      "distance`, 0 for the other. Units: s.",
      not_negative);
    prm.add_parameter(
      "Rolled distance",
      rolled_distance,
      "Rolled distance at which a transient run ends, at constant "
      "speed. Units: m.",
      not_negative);
    prm.add_parameter("Time step",
                      time_step,
                      "Length of a step. Give this or `Step length`, 0 for the "
                      "other. Units: s.",
                      not_negative);
    prm.add_parameter(
      "Step length",
      step_length,
      "Distance rolled in one step, at constant speed. Units: m.",
      not_negative);
    prm.add_parameter(
      "Maximum halvings",
      maximum_halvings,
      "How many times in a row the step is halved when the contact "
      "solve fails, before the run stops. Units: 1.",
      Patterns::Integer(0, 30));
  }



  void
  TimeParameters::declare_scheme(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    prm.add_parameter(
      "Theta",
      theta,
      "The theta-scheme's parameter: 0.5 keeps the energy, 1 damps "
      "most. Units: 1.",
      Patterns::Double(0.5, 1.));
    declare_choice(
      prm,
      "Bodies",
      bodies,
      named_bodies,
      "`full`: all unknowns of the bodies. `reduced`: their modes up to "
      "Modes/Cut-off ratio times Modes/Maximum frequency, and the static "
      "compliance of what these leave out.");
    prm.add_parameter("Inertia",
                      inertia,
                      "Whether the bodies have mass; without it, quasi-static "
                      "rolling in time.");
    declare_choice(prm,
                   "Mass",
                   mass,
                   named_masses,
                   "Mass matrix: `lumped` or `consistent`.");
    prm.add_parameter("Rayleigh alpha",
                      rayleigh_alpha,
                      "Damping C = alpha M + beta K. Units: 1/s.",
                      not_negative);
    prm.add_parameter("Rayleigh beta",
                      rayleigh_beta,
                      "Damping C = alpha M + beta K. Units: s.",
                      not_negative);
    declare_choice(
      prm,
      "Contact law",
      contact_law,
      named_contact_laws,
      "Unilateral contact in time: `shifted` (gap of Jean's shifted "
      "configuration) or `gap` (gap plus step times velocity).");
  }



  void
  TimeParameters::declare_start(ParameterHandler &prm)
  {
    declare_choice(prm,
                   "Initial state",
                   initial_state,
                   named_initial_states,
                   "`rest`, undeformed and without traction, or `steady`, the "
                   "steady rolling state at t = 0.");
    prm.add_parameter(
      "Hold approach",
      hold_approach,
      "Whether Contact/Normal load is that of the steady initial state alone, "
      "and the approach stays what it is there.");
    prm.add_parameter(
      "Excite mode",
      excite_mode,
      "With Bodies = reduced the run starts in the vibration about the steady "
      "state that grows and is nearest to this frequency, or in the nearest if "
      "none grows, see Analysis = stability; 0 for none. Units: Hz.",
      Patterns::Double(0.));
    prm.add_parameter("Excite velocity",
                      excite_velocity,
                      "Largest velocity of wheel over rail in the contact that "
                      "`Excite mode` starts with. Units: m/s.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Initial velocity",
      initial_velocity,
      "Velocity of a wheel with Hub = free or mass at the start, along z: "
      "negative towards the rail. Units: m/s.",
      Patterns::Double());
  }



  void
  TimeParameters::declare_histories(ParameterHandler &prm)
  {
    const std::string forms =
      ", a number, an expression in t (s), `FILE.csv` or `table: FILE column` "
      "(time in s first; file relative to this one); empty: as in section "
      "Contact. ";
    const auto declare =
      [&](const std::string &name, std::string &text, const std::string &help) {
        prm.add_parameter(name, text, help, Patterns::Anything());
      };
    declare("Approach",
            approach,
            "Approach over time" + forms +
              "Contact/Approach must be given too, the mesh is made for it. "
              "Units: m.");
    declare("Normal load",
            normal_load,
            "Normal load over time" + forms +
              "Contact/Normal load must be given too, the mesh is made for it. "
              "Units: N.");
    declare("Creepage x",
            creepage_x,
            "Longitudinal creepage over time" + forms + "Units: 1.");
    declare("Creepage y",
            creepage_y,
            "Lateral creepage over time, 3D only" + forms + "Units: 1.");
    declare("Spin",
            spin,
            "Spin creepage over time, 3D only" + forms + "Units: 1/m.");
    const std::string instead =
      " on the wheel over time, in place of the creepage, which is found for "
      "it" +
      forms;
    declare("Longitudinal force",
            longitudinal_force,
            "Force of friction along x" + instead + "Units: N.");
    declare("Lateral force",
            lateral_force,
            "Force of friction along y, 3D only," + instead + "Units: N.");
    declare("Spin moment",
            spin_moment,
            "Moment of friction about the normal, 3D only," + instead +
              "Units: N m.");
    declare("Speed",
            speed,
            "Rolling speed over time, of the sign of Contact/Speed" + forms +
              "Units: m/s.");
  }



  void
  TimeParameters::declare_output(ParameterHandler &prm)
  {
    prm.add_parameter("Field interval",
                      field_interval,
                      "Fields are written every so many steps; 0 for none. "
                      "Units: 1.",
                      Patterns::Integer(0));
    prm.add_parameter(
      "Checkpoint interval",
      checkpoint_interval,
      "A checkpoint for --resume is written every so many steps; "
      "0 leaves it to `Checkpoint seconds`. Units: 1.",
      Patterns::Integer(0));
    prm.add_parameter(
      "Checkpoint seconds",
      checkpoint_seconds,
      "A checkpoint is written after so much wall time, the first ones "
      "sooner, and later where they would take more than 3 % of it; 0 leaves "
      "it to `Checkpoint interval`. Units: s.",
      Patterns::Double(0.));
    prm.add_parameter("Damping frequency",
                      damping_frequency,
                      "Frequency f for which the numerical damping "
                      "(theta - 1/2) 2 pi f dt is said; 0 for none. Units: Hz.",
                      Patterns::Double(0.));
  }



  void
  TimeParameters::declare_end(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Stop when periodic",
      stop_when_periodic,
      "Whether the run ends before `End time` once the motion repeats itself, "
      "or nothing moves any more, and its limit cycle is measured: cycle.csv, "
      "cycle.svg, cycle_patch.csv.");
    prm.add_parameter(
      "Periodic tolerance",
      periodic_tolerance,
      "What a period may differ by from those before it, as a part of the "
      "range of each velocity and force, and by how much the amplitude may "
      "still be away from where it is going. Units: 1.",
      Patterns::Double(1e-6, 0.1));
    prm.add_parameter("Periodic after",
                      periodic_after,
                      "Beginning of the run that is left out when periods are "
                      "looked for. Units: s.",
                      Patterns::Double(0.));
  }



  namespace
  {
    void
    require_constant(const TimeFunction &speed,
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



  TimeSteps
  TimeParameters::steps(const TimeFunction &speed) const
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



  double
  TimeParameters::numerical_damping(const double step) const
  {
    return (theta - 0.5) * 2 * numbers::PI * damping_frequency * step;
  }



  std::set<std::string>
  TimeParameters::free_on_resume()
  {
    return {"Output/",
            "Spectrum/",
            "Sound/Density of air",
            "Sound/Speed of sound",
            "Sound/Distance",
            "Sound/Skipped time",
            "Sound/WAV file",
            "Sound/Sampling rate",
            "Sound/Full scale pressure",
            "Body solver",
            "Time/End time",
            "Time/Rolled distance",
            "Time/Stop when periodic",
            "Time/Periodic tolerance",
            "Time/Periodic after",
            "Time/Checkpoint interval",
            "Time/Checkpoint seconds"};
  }
} // namespace RollingContact
