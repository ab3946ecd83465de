#include "complaint.h"
#include "scene_run.h"
#include "scratch_folder.h"
#include "wheel_on_block.h"

#include <rolling_contact/tables/session.h>
#include <rolling_contact/wheelset/curve_walk.h>
#include <rolling_contact/wheelset/found_place.h>
#include <rolling_contact/wheelset/hunting.h>

#include <array>
#include <cmath>
#include <random>

using namespace RollingContact;

/** Wheelsets on track: how they move, what their wheels do, where they run. */
BOOST_AUTO_TEST_SUITE(wheelsets)

namespace
{
  const double r0 = 0.46, mm = 1e-3;

  /** S1002 on 60E1 over a disc and a block, on a curved surface. */
  SceneParameters wheelset_scene()
  {
    SceneParameters scene        = wheel_on_block(6);
    scene.wheel.radius           = r0;
    scene.profiles.wheel_profile = "S1002";
    scene.profiles.rail_profile  = "60E1";
    scene.profiles.surface_kind  = Profiles::SurfaceKind::curved;
    scene.contact.speed          = 20.;
    return scene;
  }

  WheelsetParameters sprung()
  {
    WheelsetParameters wheelset;
    wheelset.yaw_stiffness  = 10e6;
    wheelset.ahead_of_frame = 0.9;
    return wheelset;
  }

  /** On the way of an analysis, with half-spaces: quick. */
  struct Walk
  {
    Walk(const SceneParameters &scene, const WheelsetParameters &wheelset)
      : wheelset(wheelset)
      , situation(scene)
      , gear(situation, this->wheelset, true)
      , pair(gear.wheels(0))
      , balance(gear.balance(0))
      , walk(gear)
    {
      walk.begin();
    }

    const WheelsetState &to(const CurveCase &target)
    {
      walk.go_to(target);
      return gear.now().wheelsets[0];
    }

    const WheelsetParameters wheelset;
    const Situation          situation;
    RunningGear              gear;
    WheelPair               &pair;
    Equilibrium             &balance;
    CurveWalk                walk;
  };

  /** Written to a file as a pair of columns in mm. */
  void write_profile(const std::filesystem::path               &file,
                     const double                               from,
                     const double                               to,
                     const std::function<double(const double)> &z)
  {
    std::ofstream stream(file);
    stream.precision(12);
    const int n = 400;
    for (int k = 0; k <= n; ++k)
      {
        const double y = from + (to - from) * k / n;
        stream << 1e3 * y << ' ' << 1e3 * z(y) << '\n';
      }
  }
  /** Cones on rails with a round head. */
  SceneParameters cone_scene(const ScratchFolder &scratch,
                             const double         slope,
                             const double         crown)
  {
    write_profile(scratch.scratch / "cone.txt",
                  -50 * mm,
                  50 * mm,
                  [&](const double y) { return -slope * y; });
    write_profile(scratch.scratch / "crown.txt",
                  -36 * mm,
                  36 * mm,
                  [&](const double y) {
                    const double side = std::max(0., -y - 30 * mm);
                    return crown - std::sqrt(crown * crown - y * y) + 8 * side;
                  });
    SceneParameters scene           = wheelset_scene();
    scene.prm_folder                = scratch.scratch;
    scene.profiles.wheel_profile    = "cone.txt";
    scene.profiles.rail_profile     = "crown.txt";
    scene.profiles.inclination      = std::to_string(slope);
    scene.profiles.smoothing_length = 0.;
    return scene;
  }
} // namespace

/**
 * The slip at the contact by the formulas for small yaw: along, 1 - kappa y +
 * Omega r/V; across, y' and what the curve adds ahead of the middle, times
 * cos(delta), and yaw Omega r / cos(delta), as a yawed flange touches ahead,
 * where it comes down; spin, Omega sin(delta)/V - kappa cos(delta).
 */
BOOST_AUTO_TEST_CASE(a_curve_is_in_the_slip)
{
  SceneParameters scene       = wheelset_scene();
  scene.contact.vertical_load = 60e3;
  scene.profiles.creepage_source =
    ProfileParameters::CreepageSource::kinematics;
  const double V = 20., kappa = -0.02, aside = 0.04, rate = -43.6;
  scene.profiles.shift            = 5 * mm;
  scene.profiles.yaw              = 2e-3;
  scene.profiles.pitch_rate       = rate;
  scene.profiles.curve_radius     = 1 / kappa;
  scene.profiles.lateral_velocity = aside;
  for (const bool is_left : {false, true})
    {
      scene.profiles.is_left = is_left;
      const Situation               here(scene);
      const Profiles::ContactFrame &frame = *here.frame;
      const double r = frame.origin().rolling_radius, delta = frame.angle(),
                   yaw = scene.profiles.yaw, ahead = frame.origin().x;
      const Creepages found = here.contact.creepages;
      BOOST_TEST(
        std::abs(found.x + 1 - kappa * frame.track_y() + rate * r / V) < 2e-5);
      BOOST_TEST(std::abs(found.y -
                          (aside / V + kappa * ahead) * std::cos(delta) -
                          yaw * rate * r / V / std::cos(delta)) < 2e-5);
      BOOST_TEST(std::abs(found.spin - rate / V * std::sin(delta) +
                          kappa * std::cos(delta)) < 2e-3);
      // at the origin the rows of the place say the same
      const auto u     = frame.velocities(*here.motion);
      const auto place = frame.place_in_track(0., 0., 0.);
      BOOST_TEST(Profiles::dot(place.along, u) == found.x,
                 boost::test_tools::tolerance(1e-6));
      BOOST_TEST(Profiles::dot(place.across, u) == found.y,
                 boost::test_tools::tolerance(1e-6));
      BOOST_TEST(place.at[1] == frame.track_y(),
                 boost::test_tools::tolerance(1e-9));
    }
}

/**
 * The work of the forces that hold a wheelset on its way is that of friction on
 * the slip: forces are conjugate to the motion, for either wheel, on tread and
 * flange.
 */
BOOST_AUTO_TEST_CASE(forces_do_the_work_of_friction)
{
  std::mt19937 random(7);
  const auto   between = [&](const double from, const double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  for (const auto kind :
       {Profiles::SurfaceKind::curved, Profiles::SurfaceKind::plane})
    for (const bool is_left : {false, true})
      {
        SceneParameters scene       = wheelset_scene();
        scene.profiles.surface_kind = kind;
        scene.profiles.is_left      = is_left;
        scene.profiles.creepage_source =
          ProfileParameters::CreepageSource::kinematics;
        scene.contact.vertical_load = 60e3;
        scene.mesh.compliance       = Compliance::half_spaces;
        Session session{Situation(scene)};
        for (unsigned int k = 0; k < 6; ++k)
          {
            const double kappa  = between(-0.04, 0.04),
                         excess = between(-5e-3, 5e-3);
            session.set("Profiles/Lateral shift", between(-5.5 * mm, 5.5 * mm));
            session.set("Profiles/Yaw", between(-0.01, 0.01));
            session.set("Profiles/Curve radius", 1 / kappa);
            session.set("Profiles/Pitch rate", -(1 + excess) * 20. / r0);
            const SessionState found = session.solve();
            BOOST_TEST_REQUIRE(found.track_forces.has_value());
            const TrackForces &forces = *found.track_forces;
            const double work = -forces.force_x - forces.moment_z * kappa +
                                forces.axle_torque * (1 + excess) / r0;
            BOOST_TEST(found.forces.creep_work > 1.);
            BOOST_TEST(std::abs(work - found.forces.creep_work) <
                       1e-9 * found.forces.friction_force);
            // the load is what was asked for, and acts beside the middle
            BOOST_TEST(forces.force_z == -60e3,
                       boost::test_tools::tolerance(1e-6));
            BOOST_TEST(forces.moment_x == (is_left ? 1. : -1.) * 60e3 * 0.755,
                       boost::test_tools::tolerance(0.05));
          }
      }
}

/**
 * A wheelset of cones runs in a curve where its radii differ as that asks, at
 * -e r0 / (lambda R) with the conicity of cones on round rails: they roll as
 * they shift (Wickens, Fundamentals of Rail Vehicle Dynamics).
 */
BOOST_AUTO_TEST_CASE(cones_steer_as_their_radii)
{
  const ScratchFolder scratch;
  const double        slope = 1. / 20, crown = 0.3;
  SceneParameters     scene = cone_scene(scratch, slope, crown);
  Walk                walk(scene, WheelsetParameters());
  const double        R     = 3000.;
  const auto         &found = walk.to({1 / R, 0., 0., 0.});
  BOOST_TEST(found.largest_residual() < Equilibrium::tolerance);
  const double e = walk.pair.half_base(),
               conicity =
                 slope * (1 + crown * slope / e) / (1 - r0 * slope / e);
  BOOST_TEST(found.place.shift == -e * r0 / (conicity * R),
             boost::test_tools::tolerance(0.005));
  // free to turn, it steers itself: next to no friction
  BOOST_TEST(std::abs(found.place.yaw) < 2e-4);
}

BOOST_AUTO_TEST_CASE(a_mirror_shows_the_same_numbers)
{
  SceneParameters scene            = wheelset_scene();
  scene.mesh.elements_across_patch = 8;
  Walk        right(scene, sprung());
  const auto &middle = right.balance.now();
  BOOST_TEST(std::abs(middle.place.shift) < 1e-9);
  BOOST_TEST(std::abs(middle.place.yaw) < 1e-9);
  // to the left the sides are exchanged and solved as a curve to the right
  const double    R = 600.;
  const CurveCase acting{1 / R, 0., -0.9 / R, 0.};
  const auto      here = right.to(acting);
  BOOST_TEST(here.place.shift < -1 * mm);
  const auto there = here.mirrored();
  BOOST_TEST(there.place.shift == -here.place.shift);
  BOOST_TEST(there.acting.curvature == -1 / R);
  BOOST_TEST(there.wheels[0].forces.force_y == -here.wheels[1].forces.force_y);
  BOOST_TEST(there.wheels[1].creep_work == here.wheels[0].creep_work);
  // as solved to the left, without mirrors, on meshes that are as new
  WheelPair left_pair(right.situation, right.wheelset, true),
    right_pair(right.situation, right.wheelset, true);
  Equilibrium left(left_pair, right.wheelset),
    again(right_pair, right.wheelset);
  BOOST_TEST(left.solve(acting.mirrored(), there));
  BOOST_TEST(again.solve(acting, here));
  BOOST_TEST(left.now().place.shift == -again.now().place.shift,
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(left.now().wheels[1].forces.force_x ==
               again.now().wheels[0].forces.force_x,
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(again.now().place.shift == here.place.shift,
             boost::test_tools::tolerance(1e-3));
  BOOST_TEST(left.now().wheels[1].forces.force_x ==
               there.wheels[1].forces.force_x,
             boost::test_tools::tolerance(8e-3));
}

/**
 * What the balances say, from the forces of the wheels: the suspension holds
 * what the rails turn, statics share the axle load, a torque drives.
 */
BOOST_AUTO_TEST_CASE(forces_are_in_balance)
{
  WheelsetParameters wheelset = sprung();
  wheelset.lateral_force      = 6e3;
  wheelset.axle_torque        = 400.;
  wheelset.load_transfer      = 2e3;
  Walk         walk(wheelset_scene(), wheelset);
  const double R     = 800.;
  const auto   found = walk.to({1 / R, 6e3, -0.9 / R + 1e-4, 400.});
  const auto  &right = found.wheels[0], &left = found.wheels[1];
  const double W = wheelset.axle_load;
  BOOST_TEST(std::abs(right.forces.force_y + left.forces.force_y + 6e3) <
             2e-5 * W);
  BOOST_TEST(std::abs(right.forces.axle_torque + left.forces.axle_torque -
                      400.) < 2e-5 * W);
  // 400 N m drive it forwards: rails push by 400/r0 beyond what it needs
  BOOST_TEST(right.forces.force_x + left.forces.force_x > 0.8 * 400. / r0);
  const double moment = 10e6 * (-0.9 / R + 1e-4 - found.place.yaw);
  BOOST_TEST(moment == found.yaw_moment, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(
    std::abs(right.forces.moment_z + left.forces.moment_z +
             found.place.shift * (right.forces.force_x + left.forces.force_x) +
             moment) < 2e-5 * W);
  const double carried = r0 * 6e3 / (2 * walk.pair.half_base()) + 2e3;
  BOOST_TEST(-right.forces.force_z == W / 2 + carried,
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(-left.forces.force_z == W / 2 - carried,
             boost::test_tools::tolerance(1e-6));
  // what is given in place of a balance is found again
  WheelsetParameters given;
  given.axle_torque   = 400.;
  given.load_transfer = 2e3;
  given.shift         = found.place.shift;
  given.yaw           = found.place.yaw;
  Walk       other(wheelset_scene(), given);
  const auto again = other.to({1 / R, 0., 0., 400.});
  // on other meshes of few elements
  BOOST_TEST(again.acting.lateral_force == 6e3,
             boost::test_tools::tolerance(0.08));
  BOOST_TEST(again.yaw_moment == moment, boost::test_tools::tolerance(0.03));
}

/**
 * Cones on straight track: slow motions have the wavelength of Klingel, and the
 * speed from which springs no longer hold the wheelset is that of two creep
 * coefficients f, A e^2 + B = 0 and V^2 = 4 f^2 e^2 w^2 / (4 f^2 e lambda / r0
 * - B^2 / e^2) with A = k - m w^2, B = K - I w^2.
 */
BOOST_AUTO_TEST_CASE(cones_hunt_as_klingel_and_wickens_say)
{
  const ScratchFolder scratch;
  const double        slope = 1. / 40, crown = 0.3, W = 120e3;
  SceneParameters     scene = cone_scene(scratch, slope, crown);
  WheelsetParameters  wheelset;
  wheelset.yaw_stiffness = 1e6;
  wheelset.hunting       = {1500., 1000., 100., 1e6, 0., 0.};
  Walk walk(scene, wheelset);
  BOOST_TEST(std::abs(walk.balance.now().place.shift) < 1e-9);
  const auto derivatives = walk.balance.motion_derivatives(true);
  BOOST_TEST_REQUIRE(derivatives.has_value());
  const auto  &G = *derivatives;
  const double e = walk.pair.half_base(),
               conicity =
                 slope * (1 + crown * slope / e) / (1 - r0 * slope / e),
               f = W * G(0, 1) / 2, pi = std::acos(-1.);
  // yaw is lateral creepage the other way
  BOOST_TEST(G(0, 3) == -G(0, 1), boost::test_tools::tolerance(3e-3));
  BOOST_TEST(f > 1e6);
  // of a free one: a wavelength of 2 pi (e r0 / conicity)^(1/2)
  Eigen::Matrix<double, 3, 5> free = G;
  free(1, 1) += wheelset.yaw_stiffness / W;
  const double       slow            = 0.05;
  WheelsetParameters unsprung        = wheelset;
  unsprung.hunting.lateral_stiffness = 0.;
  const Hunting of_free(unsprung, {free}, r0);
  double        frequency = 0.;
  for (const auto &value : of_free.eigenvalues(slow))
    frequency = std::max(frequency, value.imag() / (2 * pi));
  BOOST_TEST(slow / frequency == 2 * pi * std::sqrt(e * r0 / conicity),
             boost::test_tools::tolerance(0.015));
  // nothing but friction holds it: it hunts from walking pace on
  BOOST_TEST(of_free.critical_speed(200.).value_or(99.) < 5.);
  // of the sprung one
  const Hunting sprung(wheelset, {G}, r0);
  const auto    critical = sprung.critical_speed(200.);
  BOOST_TEST_REQUIRE(critical.has_value());
  const double k = 1e6, K = 1e6, m = 1500., I = 1000.,
               w2 = (k * e * e + K) / (m * e * e + I), B = K - I * w2,
               V2 = 4 * f * f * e * e * w2 /
                    (4 * f * f * e * conicity / r0 - B * B / (e * e));
  BOOST_TEST(*critical == std::sqrt(V2), boost::test_tools::tolerance(0.02));
  BOOST_TEST(sprung.eigenvalues(0.99 * *critical).front().real() < 0.);
  BOOST_TEST(sprung.eigenvalues(1.01 * *critical).front().real() > 0.);
}

/**
 * Cones under a bogie of springs that do not give: its wavelength is 2 pi
 * (r0 (e^2 + a^2 f22/f11) / (e conicity))^(1/2), of wheelsets that creep by
 * f22 across and f11 along. With its frame held by springs it is two
 * wheelsets.
 */
BOOST_AUTO_TEST_CASE(a_stiff_bogie_of_cones_has_a_longer_wave)
{
  const ScratchFolder scratch;
  const double        slope = 1. / 40, crown = 0.3, a = 0.9;
  WheelsetParameters  alone;
  alone.hunting = {1500., 1000., 100., 0., 0., 0.};
  Walk       walk(cone_scene(scratch, slope, crown), alone);
  const auto G = walk.balance.motion_derivatives(true);
  BOOST_TEST_REQUIRE(G.has_value());
  const double W = alone.axle_load, e = walk.pair.half_base(),
               conicity =
                 slope * (1 + crown * slope / e) / (1 - r0 * slope / e),
               creep_ratio = -(*G)(0, 1) * e * e / (*G)(1, 4),
               pi          = std::acos(-1.);
  BOOST_TEST(creep_ratio == 1., boost::test_tools::tolerance(0.3));
  const auto in_frame = [&](const double k, const double K) {
    WheelsetParameters bogie        = alone;
    bogie.is_bogie                  = true;
    bogie.ahead_of_frame            = a;
    bogie.yaw_stiffness             = K;
    bogie.hunting.lateral_stiffness = k;
    bogie.frame.mass                = 2000.;
    bogie.frame.yaw_inertia         = 1500.;
    return bogie;
  };
  const auto held = [&](const double k, const double K) {
    Hunting::Derivatives by_motion = *G;
    by_motion(0, 0) -= k / W;
    by_motion(1, 1) -= K / W;
    return by_motion;
  };
  const auto slow_wave = [&](const Hunting &hunting) {
    const double slow = 0.05;
    double       wave = 0.;
    for (const auto &value : hunting.eigenvalues(slow))
      if (value.imag() > 1e-3) // not those of springs, to rounding
        wave = std::max(wave, 2 * pi * slow / value.imag());
    return wave;
  };
  const Hunting stiff(in_frame(1e9, 1e9), {held(1e9, 1e9), held(1e9, 1e9)}, r0);
  BOOST_TEST(slow_wave(stiff) ==
               2 * pi *
                 std::sqrt(r0 * (e * e + creep_ratio * a * a) / (e * conicity)),
             boost::test_tools::tolerance(0.008));
  // a frame that does not move holds wheelsets as springs to the ground do
  const double       k = 2e6, K = 3e6;
  WheelsetParameters still      = in_frame(k, K);
  still.frame.mass              = 1e9;
  still.frame.yaw_inertia       = 1e9;
  still.frame.lateral_stiffness = 1e15;
  still.frame.yaw_stiffness     = 1e15;
  WheelsetParameters sprung     = alone;
  sprung.yaw_stiffness          = K;
  sprung.hunting                = {1500., 1000., 100., k, 0., 0.};
  Hunting::Derivatives yawing   = *G;
  yawing(1, 1) -= K / W;
  const auto critical = Hunting(sprung, {yawing}, r0).critical_speed(300.),
             of_bogie = Hunting(still, {held(k, K), held(k, K)}, r0)
                          .critical_speed(300.);
  BOOST_TEST_REQUIRE((critical && of_bogie));
  BOOST_TEST(*of_bogie == *critical, boost::test_tools::tolerance(1e-4));
}

/**
 * The frame of a bogie is in balance, each wheelset is where it would be alone
 * with that frame and force, and the trailing one stands further inside.
 */
BOOST_AUTO_TEST_CASE(a_bogie_is_two_wheelsets_in_a_frame)
{
  WheelsetParameters bogie        = sprung();
  bogie.is_bogie                  = true;
  bogie.hunting.lateral_stiffness = 7.8e6;
  bogie.frame.yaw_stiffness       = 2e5;
  Walk            walk(wheelset_scene(), bogie);
  const double    R = 500., a = 0.9, W = bogie.axle_load, H = -4e3;
  const CurveCase acting{1 / R, H, 2e-3, 0.};
  walk.to(acting);
  walk.gear.polish();
  const RunningState &found = walk.gear.now();
  const auto         &one = found.wheelsets[0], &two = found.wheelsets[1];
  BOOST_TEST(found.frame_left.lpNorm<Eigen::Infinity>() < 5e-8);
  for (const WheelsetState &wheelset : found.wheelsets)
    BOOST_TEST(wheelset.largest_residual() < 5e-8);
  const double y = found.frame[0], psi = found.frame[1];
  BOOST_TEST(one.lateral_force + two.lateral_force == H,
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(std::abs(a * (one.lateral_force - two.lateral_force) +
                      one.yaw_moment + two.yaw_moment - 2e5 * (2e-3 - psi)) <
             1e-6 * W);
  BOOST_TEST(one.lateral_force ==
               7.8e6 * (y + a * psi - a * a / (2 * R) - one.place.shift),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(two.yaw_moment == 10e6 * (psi + a / R - two.place.yaw),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(one.place.shift < two.place.shift - 0.3 * mm);
  // alone, with that force and that frame
  for (unsigned int i = 0; i < 2; ++i)
    {
      const WheelsetState &with = found.wheelsets[i];
      Walk                 alone(wheelset_scene(), sprung());
      Equilibrium         &balance = alone.balance;
      BOOST_TEST(balance.solve(
        {1 / R, with.lateral_force, i == 0 ? psi - a / R : psi + a / R, 0.},
        with));
      BOOST_TEST(std::abs(balance.now().place.shift - with.place.shift) <
                 0.05 * mm); // on other meshes
      BOOST_TEST(std::abs(balance.now().place.yaw - with.place.yaw) < 1e-5);
    }
}

/**
 * Rails on springs give way to what the wheels press them by, and the wheels
 * run on them as on rigid rails that stand there: a wheelset that is pushed
 * takes both along by half its force over their stiffness. Rails that are stiff
 * are rigid.
 */
BOOST_AUTO_TEST_CASE(rails_give_way_on_their_springs)
{
  const double       R = 400., k = 20e6, H = -8e3;
  const CurveCase    acting{1 / R, H, -0.9 / R, 0.};
  WheelsetParameters wheelset = sprung();
  Walk               rigid(wheelset_scene(), wheelset);
  const auto         on_rigid = rigid.to(acting);
  wheelset.rail_stiffness     = 1e13;
  Walk       stiff(wheelset_scene(), wheelset);
  const auto on_stiff = stiff.to(acting);
  BOOST_TEST(std::abs(on_stiff.place.shift - on_rigid.place.shift) < 3e-7);
  BOOST_TEST(std::abs(on_stiff.place.yaw - on_rigid.place.yaw) < 2e-6);

  wheelset.rail_stiffness = k;
  Walk walk(wheelset_scene(), wheelset);
  walk.to(acting);
  BOOST_TEST(walk.balance.polish());
  const WheelsetState &found = walk.balance.now();
  for (unsigned int wheel = 0; wheel < 2; ++wheel)
    BOOST_TEST(k * found.place.rails[wheel] ==
                 -found.wheels[wheel].forces.force_y,
               boost::test_tools::tolerance(1e-5));
  // the outer one, pressed outwards, by some tenths of a millimetre
  BOOST_TEST(found.place.rails[1] < -0.3 * mm);
  BOOST_TEST(found.place.shift < on_rigid.place.shift - 0.2 * mm);
  // mirrored, on exchanged rails
  const WheelsetPlace mirror = found.place.mirrored();
  BOOST_TEST(mirror.on_rail(0) == -found.place.on_rail(1));
  BOOST_TEST(mirror.on_rail(1) == -found.place.on_rail(0));

  // cones in the middle go with the rails
  const ScratchFolder   scratch;
  const SceneParameters cones = cone_scene(scratch, 1. / 20, 0.3);
  const CurveCase       pushed{0., 4e3, 0., 0.};
  wheelset                = WheelsetParameters();
  wheelset.yaw_stiffness  = 10e6;
  wheelset.rail_stiffness = k;
  Walk         sprung_rails(cones, wheelset);
  const double on_springs = sprung_rails.to(pushed).place.shift;
  wheelset.rail_stiffness.reset();
  Walk         still(cones, wheelset);
  const double apart = on_springs - still.to(pushed).place.shift;
  BOOST_TEST(apart == 4e3 / (2 * k), boost::test_tools::tolerance(3e-3));
}

BOOST_AUTO_TEST_CASE(sides_may_differ)
{
  // a left wheel that is smaller by 0.2 mm runs to the left on straight track,
  // to where radii are the same
  WheelsetParameters wheelset;
  wheelset.left_wheel_radius = r0 - 0.2 * mm;
  Walk        walk(wheelset_scene(), wheelset);
  const auto &found = walk.balance.now();
  BOOST_TEST(found.largest_residual() < Equilibrium::tolerance);
  BOOST_TEST(found.place.shift < -0.2 * mm);
  BOOST_TEST(std::abs(found.wheels[0].forces.force_x) < 20.);
}

BOOST_AUTO_TEST_CASE(wheelsets_that_cannot_be_are_refused)
{
  const auto complaint_of = [](const auto &change) {
    WheelsetParameters wheelset;
    change(wheelset);
    return complaint([&]() { wheelset.check(); });
  };
  BOOST_TEST(complaint_of([](auto &w) {
               w.curve_radii = {5.};
             }).find("at least 10") != std::string::npos);
  BOOST_TEST(complaint_of([](auto &w) {
               w.curve_radii = {300., -300.};
             }).find("same side") != std::string::npos);
  BOOST_TEST(complaint_of([](auto &w) {
               w.axle_load = 0.;
             }).find("Axle load") != std::string::npos);
  BOOST_TEST(complaint_of([](auto &w) {
               w.shift         = 1e-3;
               w.lateral_force = 1.;
             }).find("Lateral force") != std::string::npos);
  BOOST_TEST(complaint_of([](auto &w) {
               w.cant_deficiency = 0.1;
             }).find("curve") != std::string::npos);
  BOOST_TEST(complaint_of([](auto &w) {
               w.rail_stiffness = 1e3;
             }).find("rigid rails") != std::string::npos);
  // a cant deficiency pushes outwards
  WheelsetParameters wheelset;
  wheelset.curve_radii     = {-500.};
  wheelset.cant_deficiency = 0.1;
  BOOST_TEST(wheelset.cases().front().lateral_force == 120e3 * 0.1 / 1.5,
             boost::test_tools::tolerance(1e-12));
}

/**
 * The scene of a wheel has the place and the load of the equilibrium, and the
 * motion gives its creepages; a curve to the left is the mirror image.
 */
BOOST_AUTO_TEST_CASE(a_wheel_of_an_equilibrium_is_a_scene_of_its_own)
{
  SceneParameters scene     = wheelset_scene();
  scene.stability.wheels    = WheelsFound::both;
  WheelsetParameters &curve = scene.own<WheelsetParameters>();
  curve                     = sprung();
  curve.curve_radii         = {600.};
  curve.left_wheel_radius   = r0 + 0.1 * mm;
  const auto  right         = equilibrium_on_half_spaces(Situation(scene));
  const auto &state         = right.state;
  BOOST_TEST(state.largest_residual() < 1e-7);
  const Situation left = scene_of_wheel(Situation(scene), right, 1);
  BOOST_TEST(left.profiles.is_left);
  BOOST_TEST((left.inputs->stability.wheels == WheelsFound::none));
  BOOST_TEST(left.wheel.radius == r0 + 0.1 * mm);
  BOOST_TEST(left.contact.vertical_load.value() == state.wheels[1].load);
  BOOST_TEST(left.profiles.curve_radius.value() == 600.,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(left.profiles.pitch_rate.value() ==
               -(1 + state.place.excess) * 20. / r0,
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(left.motion.has_value());
  BOOST_TEST(left.frame->is_left());

  curve.left_wheel_radius.reset();
  const auto here   = equilibrium_on_half_spaces(Situation(scene));
  curve.curve_radii = {-600.};
  const auto there  = equilibrium_on_half_spaces(Situation(scene));
  BOOST_TEST(here.state.place.shift == -there.state.place.shift);
  BOOST_TEST(here.state.place.yaw == -there.state.place.yaw);
  BOOST_TEST(here.roll == -there.roll);
  BOOST_TEST(here.state.wheels[1].creep_work ==
             there.state.wheels[0].creep_work);
}

BOOST_AUTO_TEST_SUITE_END()
