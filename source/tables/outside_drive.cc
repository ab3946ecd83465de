#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/tables/outside_drive.h>

#include <cmath>
#include <string>

namespace RollingContact
{
  namespace
  {
    using Quantity = OutsideDrive::Quantity;

    const std::array<std::string, OutsideDrive::n_quantities> names{
      "normal_load",
      "approach",
      "creepage_x",
      "creepage_y",
      "spin",
      "speed",
      "longitudinal_force",
      "lateral_force",
      "spin_moment"};

    const std::array<std::string, OutsideDrive::n_quantities>
      units{"N", "m", "1", "1", "1/m", "m/s", "N", "N", "N m"};

    std::array<std::optional<double>, OutsideDrive::n_quantities>
    values_of(const StepInputs &inputs)
    {
      return {inputs.normal_load,
              inputs.approach,
              inputs.creepage_x,
              inputs.creepage_y,
              inputs.spin,
              inputs.speed,
              inputs.longitudinal_force,
              inputs.lateral_force,
              inputs.spin_moment};
    }

    /** The creepage that a force takes the place of. */
    unsigned int creepage_of(const unsigned int force)
    {
      return force - Quantity::longitudinal_force + Quantity::creepage_x;
    }

    void assign(const unsigned int  quantity,
                const TimeFunction &history,
                DrivingFunctions   &histories)
    {
      switch (quantity)
        {
          case Quantity::normal_load:
            histories.normal_load = history;
            break;
          case Quantity::approach:
            histories.approach = history;
            break;
          case Quantity::creepage_x:
            histories.creepage_x = history;
            break;
          case Quantity::creepage_y:
            histories.creepage_y = history;
            break;
          case Quantity::spin:
            histories.spin = history;
            break;
          case Quantity::speed:
            histories.speed = history;
            break;
          case Quantity::longitudinal_force:
            histories.longitudinal_force = history;
            break;
          case Quantity::lateral_force:
            histories.lateral_force = history;
            break;
          default:
            histories.spin_moment = history;
        }
    }

    std::optional<TimeFunction> &asked_force(const unsigned int force,
                                             DrivingFunctions  &histories)
    {
      return force == Quantity::longitudinal_force
               ? histories.longitudinal_force
             : force == Quantity::lateral_force ? histories.lateral_force
                                                : histories.spin_moment;
    }
  } // namespace

  OutsideDrive::OutsideDrive(const PairSpec         &scene,
                             const DrivingFunctions &of_scene)
    : scene(&scene)
    , histories(of_scene)
  {}

  void OutsideDrive::check(const StepInputs &inputs) const
  {
    const auto values = values_of(inputs);
    const auto reject = [&](const unsigned int quantity,
                            const std::string &reason) {
      throw InputError(names[quantity] + " = " +
                       significant(*values[quantity], 6) + ' ' +
                       units[quantity] + ": " + reason);
    };
    const bool load_given = histories.normal_load.has_value();
    for (unsigned int k = 0; k < n_quantities; ++k)
      if (values[k] && !std::isfinite(*values[k]))
        reject(k, "it must be finite.");
    if (values[normal_load] && !load_given)
      reject(normal_load,
             "the scene gives Contact/Approach, so that a load cannot be "
             "given; give the approach in m, or a scene with Contact/Normal "
             "load.");
    if (values[normal_load] && scene->contact.vertical_load)
      reject(normal_load,
             "the scene gives Contact/Vertical load, from which it is found; "
             "give a scene with Contact/Normal load.");
    if (values[normal_load] && *values[normal_load] < 0.)
      reject(normal_load, "contact cannot pull, it must be at least 0 N.");
    if (values[approach] && load_given)
      reject(approach,
             "the scene gives the load, so that an approach cannot be given; "
             "give normal_load in N, or a scene with Contact/Approach.");
    if (values[approach] && scene->wheel.axle_mass)
      reject(approach,
             "with Wheel/Hub = mass the axle moves by the forces on it; leave "
             "the approach out, or give a scene with Hub = clamped.");
    if (values[speed] && scene->surfaces.in_use())
      reject(speed,
             "surfaces pass at the speed of the scene, and what has passed is "
             "not known for another; give Time/Speed.");
    if (values[speed] && *values[speed] * scene->contact.flow() <= 0.)
      reject(speed, "it must keep the sign of Contact/Speed and not be 0 m/s.");
    for (const unsigned int k : {creepage_y, spin, lateral_force, spin_moment})
      if (values[k] && scene->dimension == 2)
        reject(k, "it exists in 3D only; take Dimension = 3.");
    for (unsigned int k = longitudinal_force; k < n_quantities; ++k)
      {
        if (values[k] && values[creepage_of(k)])
          reject(k,
                 "the creepage is found for it; leave " +
                   names[creepage_of(k)] + " out.");
        if (values[k] && scene->contact.friction_coefficient == 0.)
          reject(k,
                 "without friction there is no such force; give "
                 "Contact/Friction coefficient above 0.");
      }
  }

  void OutsideDrive::check_forces(const DrivingFunctions &histories,
                                  const double            time) const
  {
    const AskedForces asked = histories.forces(time);
    if (!histories.normal_load || !(asked.x || asked.y))
      return;
    const double force = std::hypot(asked.x.value_or(0.), asked.y.value_or(0.)),
                 most  = scene->contact.friction_coefficient *
                        histories.normal_load->value(time);
    if (force > 0. && force >= most)
      throw InputError(
        "longitudinal_force and lateral_force ask for " +
        significant(force, 6) + " N at t = " + significant(time, 6) +
        " s: friction carries less than mu N = " + significant(most, 6) +
        " N; give less, or the creepage.");
  }

  DrivingFunctions OutsideDrive::next(const StepInputs   &inputs,
                                      const double        time,
                                      const double        length,
                                      const BetweenValues between)
  {
    check(inputs);
    const auto       values      = values_of(inputs);
    DrivingFunctions result      = histories;
    auto             now_outside = from_outside;
    const double     end         = time + length;
    const double     just_after  = time + 1e-6 * length;
    const bool       later       = just_after > time && just_after < end;
    for (unsigned int k = 0; k < n_quantities; ++k)
      {
        now_outside[k] = values[k] || from_outside[k];
        if (k >= longitudinal_force && values[creepage_of(k)])
          {
            asked_force(k, result).reset();
            now_outside[k] = false;
          }
        if (!now_outside[k])
          continue;
        const double last  = past[k].back().second,
                     value = values[k].value_or(last);
        Points points      = past[k];
        if (between == BetweenValues::held && k != approach && later)
          points.emplace_back(just_after, value);
        points.emplace_back(end, value);
        const bool on = between == BetweenValues::linear || k == approach;
        points.emplace_back(end + length,
                            on && k == approach ? 2 * value - last : value);
        assign(k, TimeFunction(names[k], points), result);
      }
    check_forces(result, end);
    from_outside = now_outside;
    histories    = result;
    return result;
  }

  void OutsideDrive::remember(const double            time,
                              const DrivingFunctions &driving,
                              const Creepages        &creepages,
                              const Resultants       &forces)
  {
    const auto at_end = [&](const std::optional<TimeFunction> &history,
                            const double                       otherwise) {
      return history ? history->value(time) : otherwise;
    };
    const std::array<double, n_quantities> values{
      at_end(driving.normal_load, 0.),
      at_end(driving.approach, 0.),
      creepages.x,
      creepages.y,
      creepages.spin,
      driving.speed.value(time),
      at_end(driving.longitudinal_force, forces.force_x),
      at_end(driving.lateral_force, forces.force_y),
      at_end(driving.spin_moment, forces.spin_moment)};
    for (unsigned int k = 0; k < n_quantities; ++k)
      {
        past[k].emplace_back(time, values[k]);
        if (past[k].size() > 3)
          past[k].erase(past[k].begin());
      }
  }
} // namespace RollingContact
