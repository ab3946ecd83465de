#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/wheelset/fmu_states.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    using Fmu::Coordinates;

    const double straight_radius = 1e9; ///< m

    /// m between rolling radii, and how many to both sides have a mean
    const double spacing  = 2e-4;
    const int    n_beside = 10;
  } // namespace

  Fmu::Wheelset fmu_wheelset(const Situation &scene)
  {
    const double                   radius = scene.wheel.radius;
    const Profiles::WheelsetMotion motion =
      scene.profiles.motion(scene.contact.rolling_speed());
    Fmu::Inputs start{};
    start[Fmu::lateral_shift]    = scene.profiles.shift;
    start[Fmu::yaw]              = scene.profiles.yaw;
    start[Fmu::lateral_velocity] = motion.to_the_side;
    start[Fmu::axle_speed] = motion.pitch_rate.value_or(-motion.speed / radius);
    start[Fmu::speed]      = motion.speed;
    start[Fmu::curvature]  = motion.curvature;
    start[Fmu::friction]   = scene.contact.friction_coefficient;
    start[Fmu::right_load] = start[Fmu::left_load] =
      *scene.contact.vertical_load;
    return {radius, scene.profiles.tape_circle(), start};
  }

  std::shared_ptr<const Profiles::WheelOnRail>
  fmu_profiles(const Situation &scene)
  {
    return std::make_shared<const Profiles::WheelOnRail>(
      scene.profiles.wheel(scene.inputs->prm_folder),
      scene.profiles.rail(scene.inputs->prm_folder),
      scene.wheel.radius,
      scene.profiles.tape_circle());
  }

  Fmu::Quantities quantities_of(const SolvedWheel                &state,
                                const Profiles::WheelOnRail      &profiles,
                                const Profiles::WheelsetPosition &place)
  {
    const double shift  = place.shift,
                 height = profiles.first_contact(place).height -
                          profiles.wheel_radius();
    const double force_x = state.forces.force_x, force_y = state.forces.force_y,
                 force_z = state.forces.force_z,
                 moment_x =
                   state.forces.moment_x - shift * force_z + height * force_y,
                 moment_z = state.forces.moment_z + shift * force_x;
    const double sy = std::sin(place.yaw), cy = std::cos(place.yaw),
                 sr = std::sin(place.roll), cr = std::cos(place.roll);
    Fmu::Quantities found;
    found[Fmu::force_x]  = force_x;
    found[Fmu::force_y]  = force_y;
    found[Fmu::force_z]  = force_z;
    found[Fmu::moment_x] = moment_x;
    // the component along the axle is known
    found[Fmu::moment_y] =
      (state.forces.axle_torque + sy * moment_x - sr * cy * moment_z) /
      (cr * cy);
    found[Fmu::moment_z]      = moment_z;
    found[Fmu::normal_force]  = state.normal_force;
    found[Fmu::place_y]       = state.forces.pressure_y;
    found[Fmu::contact_angle] = state.forces.pressure_angle;
    found[Fmu::max_pressure]  = state.max_pressure;
    found[Fmu::friction_work] = state.creep_work;
    found[Fmu::force_bound]   = state.force_bound;
    return found;
  }

  FmuStates::FmuStates(const Situation &scene)
    : axes(scene.inputs->own<FmuParameters>().all_axes(scene))
    , wheelset(fmu_wheelset(scene))
    , speed(scene.contact.rolling_speed())
    , profiles(fmu_profiles(scene))
  {
    offsets = mean_offsets();
  }

  std::vector<double> FmuStates::mean_offsets() const
  {
    const auto         &axis  = axes[Fmu::shift_axis];
    const double        width = axis.back() - axis.front();
    const auto          n     = static_cast<int>(std::ceil(width / spacing));
    const double        step  = n > 0 ? width / n : spacing;
    std::vector<double> radii;
    for (int k = -n_beside; k <= n + n_beside; ++k)
      {
        const double shift = axis.front() + k * step,
                     roll  = resting_roll(shift, shift, 0.);
        radii.push_back(
          profiles->first_contact({shift, roll, 0.}).rolling_radius);
      }
    std::vector<double> means;
    for (int k = 0; k <= n; ++k)
      means.push_back(std::accumulate(radii.begin() + k,
                                      radii.begin() + k + 2 * n_beside + 1,
                                      0.) /
                        (2 * n_beside + 1) / wheelset.radius -
                      1.);
    return means;
  }

  double FmuStates::offset(const double shift) const
  {
    const auto &axis = axes[Fmu::shift_axis];
    return Fmu::at_equal_distances(offsets, axis.front(), axis.back(), shift);
  }

  double FmuStates::resting_roll(const double shift,
                                 const double other_shift,
                                 const double yaw) const
  {
    return Profiles::resting_roll(*profiles,
                                  *profiles,
                                  std::array<double, 2>{{shift, other_shift}},
                                  yaw);
  }

  Coordinates FmuStates::coordinates_of(std::size_t state) const
  {
    Coordinates point;
    for (std::size_t d = Fmu::n_axes; d-- > 0;)
      {
        point[d] = axes[d][state % axes[d].size()];
        state /= axes[d].size();
      }
    return point;
  }

  Fmu::WheelMotion FmuStates::motion_of(const Coordinates &point) const
  {
    const double mu = point[Fmu::friction_axis];
    return wheelset.motion({{mu * point[Fmu::along_axis] +
                               offset(point[Fmu::shift_axis]),
                             mu * point[Fmu::across_axis]}},
                           point[Fmu::turn_axis],
                           point[Fmu::yaw_axis]);
  }

  const std::vector<std::string> &FmuStates::entries()
  {
    static const std::vector<std::string> names{"Profiles/Lateral shift",
                                                "Profiles/Yaw",
                                                "Profiles/Curve radius",
                                                "Contact/Vertical load",
                                                "Profiles/Pitch rate",
                                                "Profiles/Lateral velocity",
                                                "Contact/Friction coefficient"};
    return names;
  }

  std::vector<double> FmuStates::entries_of(const Coordinates &point) const
  {
    const Fmu::WheelMotion motion = motion_of(point);
    const double           turn   = point[Fmu::turn_axis];
    return {point[Fmu::shift_axis],
            point[Fmu::yaw_axis],
            turn == 0. ? straight_radius : 1 / turn,
            point[Fmu::load_axis],
            motion.about_axle * speed,
            motion.aside * speed,
            point[Fmu::friction_axis]};
  }

  Fmu::Inputs FmuStates::inputs_at(const Coordinates &point,
                                   const bool         is_left) const
  {
    const double           side   = is_left ? -1. : 1.;
    const Fmu::WheelMotion motion = motion_of(point);
    Fmu::Inputs            inputs = wheelset.start;
    inputs[Fmu::lateral_shift]    = side * point[Fmu::shift_axis];
    inputs[Fmu::yaw]              = side * point[Fmu::yaw_axis];
    inputs[Fmu::lateral_velocity] = side * motion.aside * speed;
    inputs[Fmu::axle_speed]       = motion.about_axle * speed;
    inputs[Fmu::speed]            = speed;
    inputs[Fmu::curvature]        = side * motion.turn;
    inputs[Fmu::friction]         = point[Fmu::friction_axis];
    inputs[is_left ? Fmu::left_load : Fmu::right_load] = point[Fmu::load_axis];
    return inputs;
  }

  TableStates FmuStates::table_states() const
  {
    TableStates states;
    states.entries = entries();
    states.places.assign(states.entries.size(), "Section FMU: ");
    std::size_t n = 1;
    for (const auto &axis : axes)
      n *= axis.size();
    if (n > 1000000)
      throw InputError("Section FMU: a table of " + std::to_string(n) +
                       " states, a million is most; take fewer values.");
    for (std::size_t k = 0; k < n; ++k)
      states.values.push_back(entries_of(coordinates_of(k)));
    return states;
  }

  Fmu::Quantities FmuStates::quantities_of(const Row         &row,
                                           const Coordinates &point) const
  {
    const auto number = [&](const char *column) {
      const auto value = row(column);
      if (!value)
        throw InputError(
          "results.csv: no " + std::string(column) +
          " of a state, and an FMU needs it of all states: "
          "give more Mesh/Elements across patch, or other axes.");
      return *value;
    };
    const double shift = point[Fmu::shift_axis], yaw = point[Fmu::yaw_axis];
    SolvedWheel  state;
    state.forces.force_x        = number("force_track_x_N");
    state.forces.force_y        = number("force_track_y_N");
    state.forces.force_z        = -number("force_track_z_N");
    state.forces.moment_x       = number("moment_track_x_Nm");
    state.forces.moment_z       = number("moment_track_z_Nm");
    state.forces.axle_torque    = number("axle_torque_Nm");
    state.forces.pressure_y     = number("pressure_y_track_m");
    state.forces.pressure_angle = number("pressure_angle_rad");
    state.normal_force          = number("normal_force_N");
    state.max_pressure          = number("max_pressure_Pa");
    state.creep_work            = number("creep_work_J/m");
    state.force_bound = number("bound_force/muN") * point[Fmu::friction_axis] *
                        state.normal_force;
    return RollingContact::quantities_of(
      state, *profiles, {shift, resting_roll(shift, shift, yaw), yaw});
  }

  Fmu::WheelsetModel
  FmuStates::model(const std::vector<Fmu::Quantities> &all) const
  {
    std::vector<double> roll;
    const auto         &shifts = axes[Fmu::shift_axis];
    for (const double yaw : axes[Fmu::yaw_axis])
      for (const double shift : shifts)
        for (const double other : shifts)
          roll.push_back(resting_roll(shift, other, yaw));
    Fmu::WheelsetModel found = wheelset;
    found.table              = Fmu::WheelTable(axes, all, roll, offsets);
    return found;
  }
} // namespace RollingContact
