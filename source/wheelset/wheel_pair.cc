#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/wheelset/wheel_pair.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  WheelState WheelState::mirrored() const
  {
    WheelState other            = *this;
    other.forces.force_y        = -forces.force_y;
    other.forces.moment_x       = -forces.moment_x;
    other.forces.moment_z       = -forces.moment_z;
    other.forces.pressure_y     = -forces.pressure_y;
    other.forces.pressure_angle = -forces.pressure_angle;
    other.angle                 = -angle;
    other.steepest              = -steepest;
    return other;
  }

  WheelState wheel_state(const PairSpec &scene, const SteadyState<3> &steady)
  {
    WheelState        found;
    const Resultants &result = steady.result;
    found.load               = scene.contact.vertical_load.value_or(0.);
    found.forces           = track_forces(scene, steady.problem, steady.state);
    found.creep_work       = result.creep_work;
    found.friction_force   = result.friction_force;
    found.tangential_force = result.tangential_force;
    found.max_pressure     = result.max_pressure;
    const TangentialProblem tangential =
      tangential_problem(steady.problem, steady.state);
    for (const NodeState state : node_states(tangential, steady.state))
      found.n_stick += state == NodeState::stick;
    const auto patches = patches_of(steady);
    found.n_patches    = patches.size();
    for (const ContactPatch &patch : patches)
      {
        const double angle =
          scene.frame->angle() + scene.frame->surface(patch.centre_y).angle;
        if (&patch == &patches.front())
          found.angle = angle;
        if (std::abs(angle) > std::abs(found.steepest))
          found.steepest = angle;
      }
    return found;
  }

  namespace
  {
    /// least size of an element on the way over that of a mesh of its own
    const double smallest_on_the_way = 0.6;

    const unsigned int most_elements_on_the_way = 8;

    const unsigned int least_across_on_the_way = 6;

    const double most_nodes_on_the_way = 1500.;

    std::shared_ptr<const Profiles::WheelOnRail>
    profiles_of(const ProfileParameters     &profiles,
                const double                 radius,
                const std::filesystem::path &folder)
    {
      return std::make_shared<const Profiles::WheelOnRail>(
        profiles.wheel(folder),
        profiles.rail(folder),
        radius,
        profiles.tape_circle());
    }
  } // namespace

  WheelPair::WheelPair(const Situation          &scene,
                       const WheelsetParameters &wheelset,
                       const bool                roughly)
    : nominal_radius(scene.wheel.radius)
    , sides{{{scene, nullptr, "wheel on rail"}, {scene, nullptr, ""}}}
    , states(nullptr,
             Verbosity::quiet,
             roughly ? smallest_on_the_way : smallest_patch)
  {
    if (roughly)
      {
        MeshParameters &mesh = sides[0].scene.mesh;
        mesh.compliance      = Compliance::half_spaces;
        mesh.elements_across_patch =
          std::min(mesh.elements_across_patch, most_elements_on_the_way);
        mesh.least_elements_y = least_across_on_the_way;
        states.most_nodes     = most_nodes_on_the_way;
      }
    states.tries_last                   = true;
    const std::filesystem::path &folder = scene.inputs->prm_folder;
    const double                 radius = scene.wheel.radius;
    sides[0].profiles = profiles_of(scene.profiles, radius, folder);
    sides[1]          = sides[0];
    if (roughly)
      sides[1].bodies = "the left wheel on its rail";
    const bool other_profiles = !wheelset.left_wheel_profile.empty() ||
                                !wheelset.left_rail_profile.empty(),
               other_radius = wheelset.left_wheel_radius &&
                              *wheelset.left_wheel_radius != radius;
    if (!other_profiles && !other_radius)
      return;
    PairSpec &left = sides[1].scene;
    left.profiles  = wheelset.left_profiles(left.profiles);
    if (other_radius)
      {
        left.wheel.radius = *wheelset.left_wheel_radius;
        sides[1].bodies   = "the left wheel on its rail";
      }
    sides[1].profiles = profiles_of(left.profiles, left.wheel.radius, folder);
  }

  void WheelPair::set_profiles(
    const std::array<std::shared_ptr<const Profiles::WheelOnRail>, 2> &both)
  {
    for (unsigned int wheel = 0; wheel < 2; ++wheel)
      sides[wheel].profiles = both[wheel];
  }

  void WheelPair::swap_sides()
  {
    std::swap(sides[0], sides[1]);
  }

  double WheelPair::half_base() const
  {
    return sides[0].profiles->tape_circle_place();
  }

  double WheelPair::roll(const WheelsetPlace &place) const
  {
    return Profiles::resting_roll(*sides[0].profiles,
                                  *sides[1].profiles,
                                  {{place.on_rail(0), place.on_rail(1)}},
                                  place.yaw);
  }

  PairSpec WheelPair::scene_as(const One                        &one,
                               const bool                        is_left,
                               const Profiles::WheelsetPosition &position,
                               const WheelsetPlace              &place,
                               const double                      curvature,
                               const double                      load) const
  {
    PairSpec     scene = one.scene;
    const double speed = scene.contact.rolling_speed();
    scene.profiles.creepage_source =
      ProfileParameters::CreepageSource::kinematics;
    scene.profiles.is_left = is_left;
    scene.profiles.shift   = position.shift;
    scene.profiles.roll    = position.roll;
    scene.profiles.yaw     = position.yaw;
    scene.frame            = std::make_shared<const Profiles::ContactFrame>(
      one.profiles, position, is_left, Profiles::SurfaceKind::curved);
    scene.motion                = {speed,
                                   place.pitch_rate(speed, radius()),
                                   curvature,
                                   place.aside * speed};
    scene.contact.vertical_load = load;
    scene.take_frame_loads();
    return scene;
  }

  PairSpec WheelPair::scene_of(const unsigned int   wheel,
                               const WheelsetPlace &place,
                               const double         curvature,
                               const double         load) const
  {
    return scene_as(sides[wheel],
                    wheel == 1,
                    {place.on_rail(wheel), roll(place), place.yaw},
                    place,
                    curvature,
                    load);
  }

  PairSpec WheelPair::scene_as_right_hand(const unsigned int   wheel,
                                          const WheelsetPlace &place,
                                          const double         roll,
                                          const double         curvature,
                                          const double         load) const
  {
    const Profiles::WheelsetPosition position{place.on_rail(wheel),
                                              roll,
                                              place.yaw};
    return wheel == 0
             ? scene_as(sides[0], false, position, place, curvature, load)
             : scene_as(sides[1],
                        false,
                        Profiles::mirrored(position),
                        place.mirrored(),
                        -curvature,
                        load);
  }

  SteadyState<3> &WheelPair::checked(const unsigned int wheel,
                                     const unsigned int kind,
                                     const PairSpec    &scene)
  {
    ++n_states;
    SteadyState<3> &steady = states.solve(scene, sides[wheel].bodies, kind);
    if (!steady.solver.converged)
      throw ConvergenceError(
        std::string(wheel == 0 ? "The right-hand" : "The left-hand") +
        " wheel: " + shortfall(steady.solver, scene.solver.controls.tolerance));
    return steady;
  }

  SteadyState<3> &WheelPair::state_in_track(const unsigned int wheel,
                                            const PairSpec    &scene)
  {
    return checked(wheel, 2 + wheel, scene);
  }

  WheelState WheelPair::solve_one(const unsigned int   wheel,
                                  const WheelsetPlace &place,
                                  const double         roll,
                                  const double         curvature,
                                  const double         load)
  {
    const PairSpec scene =
      scene_as_right_hand(wheel, place, roll, curvature, load);
    const WheelState found = wheel_state(scene, checked(wheel, wheel, scene));
    return wheel == 0 ? found : found.mirrored();
  }

  bool WheelPair::reaches_all(const WheelsetPlace         &place,
                              const double                 curvature,
                              const std::array<double, 2> &loads)
  {
    bool does = true;
    for (unsigned int wheel = 0; wheel < 2; ++wheel)
      does =
        states.reaches_all(
          scene_as_right_hand(wheel, place, curvature, loads[wheel]), wheel) &&
        does;
    return does;
  }

  BothWheels WheelPair::solve(const WheelsetPlace         &place,
                              const double                 curvature,
                              const std::array<double, 2> &loads)
  {
    const double     now    = roll(place);
    const WheelState right  = solve_one(0, place, now, curvature, loads[0]);
    const bool is_symmetric = is_its_own_mirror_image() && place.shift == 0. &&
                              place.yaw == 0. && place.aside == 0. &&
                              place.rails[0] == -place.rails[1] && now == 0. &&
                              curvature == 0. && loads[0] == loads[1];
    return {{right,
             is_symmetric ? right.mirrored()
                          : solve_one(1, place, now, curvature, loads[1])}};
  }
} // namespace RollingContact
