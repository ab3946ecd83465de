#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/time_parameters.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace RollingContact
{
  namespace
  {
    void require_one_of(const std::string &first,
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

    void check_forces(const DrivingFunctions  &histories,
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
    void check_values(const DrivingFunctions  &histories,
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

  void TimeParameters::check_entries(const ContactParameters &contact,
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

  void TimeParameters::check(const ContactParameters     &contact,
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

  void TimeParameters::check_cycles(const TimeSteps   &all,
                                    const std::string &why) const
  {
    const std::uint64_t least_steps = 1000; // enough for a dozen periods
    if (!inertia)
      throw InputError(why + "Time/Inertia = false has no vibration; set it to "
                             "true.");
    const double end = all.length * all.number;
    if (periodic_after >= end)
      throw InputError("Time/Periodic after = " + text_of(periodic_after) +
                       ": the run ends at " + significant(end, 6) +
                       " s; leave less of it out, or take a later Time/End "
                       "time.");
    if (all.number < least_steps)
      throw InputError(why + "the run has " + std::to_string(all.number) +
                       " steps, and periods are looked for in the last quarter "
                       "of at least 1000; take a later Time/End time.");
  }
} // namespace RollingContact
