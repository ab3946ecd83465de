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
    declare_histories(prm);
    declare_output(prm);
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
    prm.add_parameter("Inertia",
                      inertia,
                      "Whether the bodies have mass; without it, quasi-static "
                      "rolling in time.");
    declare_choice(prm,
                   "Initial state",
                   initial_state,
                   named_initial_states,
                   "`rest`, undeformed and without traction, or `steady`, the "
                   "steady rolling state at t = 0.");
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
    prm.add_parameter(
      "Initial velocity",
      initial_velocity,
      "Velocity of a wheel with Hub = free at the start, along z: "
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



  namespace
  {
    void
    require_one_of(const std::string &first,
                   const double       first_value,
                   const std::string &second,
                   const double       second_value)
    {
      if ((first_value > 0.) == (second_value > 0.))
        throw InputError("Time/" + first + " = " + text_of(first_value) +
                         " and Time/" + second + " = " + text_of(second_value) +
                         ": Analysis = transient needs one of them above 0 "
                         "and the other 0.");
    }



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



    void
    check_forces(const DrivingFunctions  &histories,
                 const ContactParameters &contact,
                 const double             time)
    {
      const AskedForces asked = histories.forces(time);
      if (!histories.normal_load || !(asked.x || asked.y))
        return;
      const double force =
                     std::hypot(asked.x.value_or(0.), asked.y.value_or(0.)),
                   most = contact.friction_coefficient *
                          histories.normal_load->value(time);
      if (force > 0. && force >= most)
        throw InputError("Time/Longitudinal force and Lateral force ask for " +
                         text_of(force) + " N at t = " + significant(time, 6) +
                         " s: friction carries less than mu N = " +
                         text_of(most) + " N then.");
    }



    /** The rules that hold at every time. */
    void
    check_values(const DrivingFunctions  &histories,
                 const ContactParameters &contact,
                 const double             time)
    {
      const auto at_time = [&]() {
        return " at t = " + significant(time, 6) + " s: ";
      };
      histories.creepages(time);
      check_forces(histories, contact, time);
      if (histories.approach)
        histories.approach->value(time);
      if (histories.normal_load && histories.normal_load->value(time) < 0.)
        throw InputError(
          "Time/Normal load is " + text_of(histories.normal_load->value(time)) +
          at_time() + "contact cannot pull, it must be at least 0 N.");
      const double speed = histories.speed.value(time);
      if (contact.friction_coefficient > 0. && speed * contact.flow() <= 0.)
        throw InputError("Time/Speed is " + text_of(speed) + at_time() +
                         "with friction it must keep the sign of "
                         "Contact/Speed = " +
                         text_of(contact.rolling_speed()) +
                         " and not be 0 m/s.");
    }
  } // namespace



  void
  TimeParameters::check_entries(const ContactParameters &contact,
                                const unsigned int       dimension) const
  {
    require_one_of("End time", end_time, "Rolled distance", rolled_distance);
    require_one_of("Time step", time_step, "Step length", step_length);
    if (!inertia && (rayleigh_alpha > 0. || rayleigh_beta > 0.))
      throw InputError("Time/Rayleigh alpha = " + text_of(rayleigh_alpha) +
                       " and Time/Rayleigh beta = " + text_of(rayleigh_beta) +
                       ": without inertia there is no damping, set both to 0.");
    if (!approach.empty() && !contact.approach)
      throw InputError("Time/Approach = " + approach +
                       ": give Contact/Approach too, the approach in m that "
                       "the mesh is made for, and no Contact/Normal load.");
    if (!normal_load.empty() && !contact.normal_load)
      throw InputError("Time/Normal load = " + normal_load +
                       ": give Contact/Normal load too, the load in N that the "
                       "mesh is made for, and no Contact/Approach.");
    for (const auto &[force_entry, force, entry, creepage, given] :
         {std::tuple("Longitudinal force",
                     longitudinal_force,
                     "Creepage x",
                     creepage_x,
                     contact.creepages.x),
          std::tuple("Lateral force",
                     lateral_force,
                     "Creepage y",
                     creepage_y,
                     contact.creepages.y),
          std::tuple(
            "Spin moment", spin_moment, "Spin", spin, contact.creepages.spin)})
      if (!force.empty() && (!creepage.empty() || given != 0.))
        throw InputError("Time/" + std::string(force_entry) + " = " + force +
                         ": the creepage is found for it; leave Time/" + entry +
                         " and Contact/" + entry + " out.");
    if (dimension == 2 && (!lateral_force.empty() || !spin_moment.empty()))
      throw InputError("Time/" +
                       std::string(spin_moment.empty()
                                     ? "Lateral force = " + lateral_force
                                     : "Spin moment = " + spin_moment) +
                       ": it exists in 3D only; leave it empty or take "
                       "Dimension = 3.");
    if (contact.friction_coefficient == 0. &&
        (!longitudinal_force.empty() || !lateral_force.empty() ||
         !spin_moment.empty()))
      throw InputError("Time/Longitudinal force, Lateral force or Spin moment "
                       "and Contact/Friction coefficient = 0: without "
                       "friction there is no such force; leave them empty.");
    if (dimension == 2 && (!creepage_y.empty() || !spin.empty()))
      throw InputError(
        "Time/" + std::string(spin.empty() ? "Creepage y" : "Spin") + " = " +
        (spin.empty() ? creepage_y : spin) +
        ": lateral creepage and spin exist in 3D only; leave it empty or take "
        "Dimension = 3.");
  }



  void
  TimeParameters::check(const ContactParameters     &contact,
                        const unsigned int           dimension,
                        const std::filesystem::path &prm_folder) const
  {
    check_entries(contact, dimension);
    const DrivingFunctions driving = histories(contact, prm_folder);
    const TimeSteps        all     = steps(driving.speed);
    const double           end     = all.length * all.number;
    const unsigned int     n       = std::min<std::uint64_t>(all.number, 1000);
    for (unsigned int i = 0; i <= n; ++i)
      check_values(driving, contact, end * i / n);
  }



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
            "Body solver",
            "Time/End time",
            "Time/Rolled distance",
            "Time/Checkpoint interval",
            "Time/Checkpoint seconds"};
  }
} // namespace RollingContact
