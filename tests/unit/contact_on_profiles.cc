#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scene_run.h"
#include "wheel_on_block.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/patch_area.h>
#include <rolling_contact/contact/patches.h>
#include <rolling_contact/mesh/profile_patch.h>
#include <rolling_contact/references/hertz_ellipse.h>
#include <rolling_contact/surfaces/half_space_pressure.h>
#include <rolling_contact/surfaces/nominal_profiles.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace RollingContact;
using namespace RollingContact::Profiles;

BOOST_AUTO_TEST_SUITE(contact_on_profiles)

namespace
{
  const double mm = 1e-3, radius = 0.46, tape_circle = 0.75;

  /** y from -width to width, z = height(y), its slope beside it. */
  template <typename Height, typename Slope>
  ProfileCurve
  curve(const double width, const Height &height, const Slope &slope)
  {
    std::vector<CurvePoint> points;
    const int               n = 400;
    for (int k = -n; k <= n; ++k)
      {
        const double y = width * k / n;
        points.push_back({y, height(y), std::atan(slope(y))});
      }
    return ProfileCurve(points);
  }

  ProfileCurve arc(const double width, const double r)
  {
    return curve(
      width,
      [&](const double y) { return r - std::sqrt(r * r - y * y); },
      [&](const double y) { return y / std::sqrt(r * r - y * y); });
  }

  ProfileCurve cone(const double slope)
  {
    return curve(
      0.05,
      [&](const double y) { return slope * y; },
      [&](const double) { return slope; });
  }

  std::shared_ptr<const WheelOnRail> pair(const ProfileCurve &wheel,
                                          const ProfileCurve &rail)
  {
    return std::make_shared<const WheelOnRail>(wheel,
                                               rail.shifted(tape_circle, 0.),
                                               radius,
                                               tape_circle);
  }

  std::shared_ptr<const WheelOnRail>
  s1002_on_60e1(const ProfileCurve &rail = rail_head("60E1"))
  {
    return std::make_shared<const WheelOnRail>(
      s1002(), placed_rail(rail, 1. / 40, 1.435, 0.014), radius, tape_circle);
  }

  const double steel = 210e9 / (2 * (1 - 0.09)); // contact modulus, Pa

  void wheel_on_block(SceneParameters &scene)
  {
    scene                     = RollingContact::wheel_on_block(12);
    scene.contact.normal_load = 16e3;
    scene.output.body_fields  = false;
  }

  void s1002_on_60e1(SceneParameters &scene)
  {
    wheel_on_block(scene);
    scene.profiles.wheel_profile = "S1002";
    scene.profiles.rail_profile  = "60E1";
    scene.profiles.shift         = 3 * mm;
    scene.profiles.roll          = 0.;
  }
} // namespace

BOOST_AUTO_TEST_CASE(the_gap_of_arcs_is_that_of_arcs)
{
  const double       r = 0.08;
  const ContactFrame frame(pair(cone(0.), arc(0.04, r)), {}, false);
  BOOST_TEST(std::abs(frame.angle()) < 1e-9);
  for (const double x : {-6 * mm, 0., 3 * mm})
    for (const double y : {-5 * mm, 0., 1 * mm, 12 * mm})
      BOOST_TEST(
        std::abs(frame.gap(x, y).value() - (r - std::sqrt(r * r - y * y)) -
                 (radius - std::sqrt(radius * radius - x * x))) < 1e-10);
  BOOST_TEST(!frame.gap(0., 45 * mm).has_value());
}

BOOST_AUTO_TEST_CASE(the_gap_is_measured_along_the_normal)
{
  // a cone that lies on an arc: the gap along the normal of the cone
  const double       r = 0.05, slope = std::tan(-0.2);
  const ContactFrame frame(pair(cone(slope), arc(0.03, r)), {}, false);
  BOOST_TEST(frame.angle() == -0.2, boost::test_tools::tolerance(1e-6));
  for (const double y : {-4 * mm, 2 * mm, 6 * mm})
    BOOST_TEST(std::abs(frame.gap(0., y).value() -
                        (r - std::sqrt(r * r - y * y))) < 1e-9);
  // across, a section through a cone: R / cos(angle) is its radius along x
  const double here = frame.origin().rolling_radius / std::cos(0.2), x = 2 * mm;
  BOOST_TEST(frame.gap(x, 0.).value() == x * x / (2 * here),
             boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(the_left_side_is_the_mirror_image_of_the_right)
{
  const auto         profiles = s1002_on_60e1();
  const ContactFrame right(profiles, {3 * mm, 1e-4, 5e-3}, false),
    left(profiles, {-3 * mm, -1e-4, -5e-3}, true);
  BOOST_TEST(left.angle() == -right.angle());
  BOOST_TEST(left.track_y() == -right.track_y());
  for (const double y : {-3 * mm, 1 * mm})
    {
      BOOST_TEST(left.gap(2 * mm, -y).value() == right.gap(2 * mm, y).value());
      BOOST_TEST(left.slip_beyond_spin(-y) == right.slip_beyond_spin(y));
    }
  const ContactFrame right_rail(profiles,
                                {3 * mm, 1e-4, 5e-3},
                                false,
                                SurfaceKind::curved),
    left_rail(profiles, {-3 * mm, -1e-4, -5e-3}, true, SurfaceKind::curved);
  for (const double s : {-3 * mm, 1 * mm})
    {
      BOOST_TEST(left_rail.gap(2 * mm, -s).value() ==
                 right_rail.gap(2 * mm, s).value());
      BOOST_TEST(left_rail.surface(-s).angle == -right_rail.surface(s).angle);
      BOOST_TEST(left_rail.surface(-s).z == right_rail.surface(s).z);
      BOOST_TEST(left_rail.slip_of_rolling(2 * mm, -s) ==
                 -right_rail.slip_of_rolling(2 * mm, s));
    }
  const Creepages of_left  = left.creepages({20., {}}),
                  of_right = right.creepages({20., {}});
  BOOST_TEST(of_left.y == -of_right.y);
  BOOST_TEST(of_left.spin == -of_right.spin);
  const auto force = left.in_track(-100., 1000.),
             other = right.in_track(100., 1000.);
  BOOST_TEST(force[0] == -other[0]);
  BOOST_TEST(force[1] == other[1]);
}

BOOST_AUTO_TEST_CASE(a_curved_surface_follows_the_rail)
{
  // a cylinder on an arc: the gap along the normal of the arc
  const double       r = 0.05;
  const ContactFrame frame(pair(cone(0.), arc(0.03, r)),
                           {},
                           false,
                           SurfaceKind::curved);
  for (const double s : {-12 * mm, 0., 5 * mm})
    {
      const double angle = s / r, gap = r / std::cos(angle) - r, x = 3 * mm;
      const SurfacePoint at = frame.surface(s);
      BOOST_TEST(std::abs(at.y - r * std::sin(angle)) < 1e-9);
      BOOST_TEST(std::abs(at.z + r - r * std::cos(angle)) < 1e-9);
      BOOST_TEST(std::abs(at.angle - angle) < 1e-7);
      BOOST_TEST(std::abs(frame.gap(0., s).value() - gap) < 1e-9);
      BOOST_TEST(std::abs(frame.gap(x, s).value() - gap -
                          x * x / (2 * radius * std::cos(angle))) < 2e-9);
      // wheel and rail face each other
      const auto [y, z, slope] = cone(0.).at(frame.wheel_arc_length(s).value());
      BOOST_TEST(std::abs(y - at.y - gap * std::sin(angle)) < 5e-9);
      BOOST_TEST(frame.rail_angle(s) == 0.);
      // behind the contact the wheel goes up, along an inclined rail to its top
      BOOST_TEST(std::abs(frame.slip_of_rolling(x, s) +
                          x * std::sin(angle) / radius) < 1e-9);
      BOOST_TEST(std::abs(frame.slip_of_rolling(0., s)) < 1e-12);
    }
  BOOST_TEST(!frame.covers(100 * mm));
  BOOST_TEST(frame.turn_of_normal({{-1 * mm, 10.}, {1 * mm, 10.}}) == 0.);
}

BOOST_AUTO_TEST_CASE(a_spin_on_the_flange_is_that_of_its_own_plane)
{
  // slip on the flange, seen from the tread, against that in its own plane
  const auto         profiles = s1002_on_60e1();
  const ContactFrame flange(profiles, {6.5 * mm, 0., 0.}, false),
    tread(profiles, {3 * mm, 0., 0.}, false, SurfaceKind::curved);
  const double turn = flange.angle() - tread.angle();
  double       s    = 0.; // where the rail has the flange's slope
  for (double from = -40 * mm, to = 0.; to - from > 1e-9;)
    (tread.surface(s = (from + to) / 2).angle < turn ? from : to) = s;
  const double x    = 2 * mm,
               spin = -std::sin(flange.angle()) / tread.origin().rolling_radius,
               of_tread = tread.creepages({20., {}}).spin;
  BOOST_TEST(of_tread * x * std::cos(turn) + tread.slip_of_rolling(x, s) ==
               spin * x,
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(creepages_are_those_of_contact)
{
  // the Manchester benchmark, V = 2 m/s, by CONTACT: shift (mm), yaw,
  // roll, pitch rate (rad/s), creepages and spin (1/mm) in its axes, over the
  // mean of the speeds of wheel and rail. 0, 1, 2, 3, 4 and 8 mm
  const std::vector<std::array<double, 7>> cases{
    {0., 0., 0., -4.3481181, -5.665e-05, 0., 6.302e-05},
    {1., 0.0024, -5.049e-05, -4.3465752, 0.0006943, 0.002407, 0.000151},
    {2., 0.0048, -0.0001128, -4.3459197, 0.0008752, 0.004818, 0.0001746},
    {3., 0.0072, -0.0001803, -4.3451503, 0.001052, 0.007235, 0.0001998},
    {4., 0.0096, -0.0002557, -4.344093, 0.001276, 0.009662, 0.000233},
    {8., 0.0192, -0.008606, -4.2534857, 0.02127, 0.033, 0.001701}};
  const auto profiles = s1002_on_60e1(rail_head("60E1 Manchester"));
  for (const auto &[shift, yaw, roll, pitch, x, y, spin] : cases)
    {
      const ContactFrame frame(profiles, {shift * mm, roll, yaw}, false);
      const Creepages    found = frame.creepages({2., pitch});
      const double       mean  = 1 + found.x / 2; // over V, of both speeds
      BOOST_TEST(std::abs(found.x / mean - x) < 2.5e-4);
      BOOST_TEST(std::abs(found.y / mean + y) < 2.8e-4);
      // its point is the middle of the overlap: at 0 and 1 mm millimetres from
      // the first contact
      if (shift > 1.)
        BOOST_TEST(found.spin / mean == 1e3 * spin,
                   boost::test_tools::tolerance(9e-3));
    }
  const ContactFrame frame(profiles, {3 * mm, 0., 0.}, false);
  BOOST_TEST(std::abs(frame.creepages({2., {}}).x) < 1e-15);
  // backwards, the axle turns the other way and so does the spin
  BOOST_TEST(frame.creepages({-2., {}}).spin ==
             -frame.creepages({2., {}}).spin);
  BOOST_TEST(frame.spin_of_cone() == frame.creepages({2., {}}).spin,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_round_wheel_slips_as_its_radius_grows)
{
  // r(y) of a convex wheel on a flat rail, and of a cone, that has none
  const double       convex = 0.2;
  const ProfileCurve wheel  = curve(
    0.04,
    [&](const double y) { return std::sqrt(convex * convex - y * y) - convex; },
    [&](const double y) { return -y / std::sqrt(convex * convex - y * y); });
  const ContactFrame frame(pair(wheel, cone(0.)), {}, false);
  for (const double y : {-10 * mm, 4 * mm})
    BOOST_TEST(frame.slip_beyond_spin(y) ==
                 (std::sqrt(convex * convex - y * y) - convex) / radius,
               boost::test_tools::tolerance(1e-6));
  const ContactFrame of_cone(pair(cone(0.1), arc(0.03, 0.1)), {}, false);
  BOOST_TEST(std::abs(of_cone.slip_beyond_spin(8 * mm)) < 1e-8);
}

BOOST_AUTO_TEST_CASE(half_spaces_press_on_the_ellipse_of_hertz)
{
  const double                   A = 0.5 / 0.23, B = 0.5 / 0.08, load = 20e3;
  const References::HertzEllipse hertz =
    References::hertz_ellipse(load, A, B, steel);
  const std::size_t n = 48;
  const double      a = 1.3 * hertz.half_width_x, b = 1.3 * hertz.half_width_y;
  const ContactGrid grid{n, n, -a + a / n, -b + b / n, 2 * a / n, 2 * b / n};
  std::vector<double> gap;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i)
      gap.push_back(A * std::pow(grid.x(i), 2) + B * std::pow(grid.y(j), 2));
  const auto under = half_space_pressure(grid, gap, steel, load, 0.);
  BOOST_TEST(under.approach == hertz.approach,
             boost::test_tools::tolerance(2e-3));
  BOOST_TEST(*std::max_element(under.pressure.begin(), under.pressure.end()) ==
               hertz.max_pressure,
             boost::test_tools::tolerance(5e-3));
  const auto at = half_space_pressure(grid, gap, steel, {}, hertz.approach);
  BOOST_TEST(at.load == load, boost::test_tools::tolerance(3e-3));
}

BOOST_AUTO_TEST_CASE(patches_are_those_of_an_independent_half_space)
{
  // shift (mm), N, approach (mm), area (mm^2), length, from y, to y (mm): one
  // patch, one with a waist, two
  const std::vector<std::array<double, 7>> cases{
    {3., 16e3, 0.03375, 28.459, 8.54, -2.17, 2.03},
    {0., 80e3, 0.06387, 167.736, 9.86, -12.75, 7.31},
    {5.5, 80e3, 0.10797, 75.988, 16.94, -1.43, 13.31}};
  const auto profiles = s1002_on_60e1();
  for (const auto &[shift, load, approach, area, length, from, to] : cases)
    {
      const ContactFrame frame(profiles, {shift * mm, 0., 0.}, false);
      const ProfilePatch patch = profile_patch(frame, steel, load, 0.);
      BOOST_TEST(patch.approach == approach * mm,
                 boost::test_tools::tolerance(2e-3));
      double found = 0., lower = 1., upper = -1.;
      for (const ZoneBox &box : patch.boxes)
        {
          found +=
            (box.upper[0] - box.lower[0]) * (box.upper[1] - box.lower[1]);
          lower = std::min(lower, box.lower[1]);
          upper = std::max(upper, box.upper[1]);
        }
      BOOST_TEST(found == area * 1e-6, boost::test_tools::tolerance(0.03));
      BOOST_TEST(2 * patch.half_width_x == length * mm,
                 boost::test_tools::tolerance(0.06));
      BOOST_TEST(std::abs(lower - from * mm) < 0.4 * mm);
      BOOST_TEST(std::abs(upper - to * mm) < 0.4 * mm);
    }
}

BOOST_AUTO_TEST_CASE(a_state_on_profiles_is_that_of_a_half_space)
{
  const SceneRun<3> run([](SceneParameters &scene) { s1002_on_60e1(scene); },
                        [](SceneParameters &scene) {
                          scene.contact.creepages = {1e-3, 1e-3, 0.191791};
                        });
  const Resultants &found = run.steady.result;
  const PatchAreas  areas = patch_areas(run.steady.problem, run.steady.state);
  BOOST_TEST(found.max_pressure == 859.13e6,
             boost::test_tools::tolerance(0.01));
  BOOST_TEST(std::hypot(found.force_x + 2707., found.force_y + 1636.6) <
             0.015 * run.friction_force());
  BOOST_TEST(areas.contact == 28.459e-6, boost::test_tools::tolerance(0.03));
  BOOST_TEST(std::abs(areas.stick - 14.86e-6) < 0.03 * 28.459e-6);
}

BOOST_AUTO_TEST_CASE(states_are_those_of_contact)
{
  // the Manchester benchmark on the tread and on the flange, both sides
  std::ifstream file(std::string(TEST_DATA) + "/manchester_a22_forces.csv");
  BOOST_REQUIRE(file.is_open());
  unsigned int n_compared = 0;
  for (std::string line; std::getline(file, line);)
    {
      if (line[0] == '#')
        continue;
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream words(line);
      double             side, shift, yaw, roll, pitch, load, x, s, peak, area;
      words >> side >> shift >> yaw >> roll >> pitch >> load >> x >> s >>
        peak >> area;
      BOOST_REQUIRE(words);
      const bool taken = side > 0. ? shift == 3. || shift == 8. : shift == 7.;
      if (!taken)
        continue;
      ++n_compared;
      const SceneRun<3> run(
        [](SceneParameters &scene) { s1002_on_60e1(scene); },
        [&](SceneParameters &scene) {
          scene.profiles.rail_profile = "60E1 Manchester";
          scene.profiles.is_left      = side < 0.;
          scene.profiles.shift        = shift * mm;
          scene.profiles.yaw          = yaw;
          scene.profiles.roll         = roll;
          scene.profiles.pitch_rate   = pitch;
          scene.profiles.creepage_source =
            ProfileParameters::CreepageSource::kinematics;
          scene.contact.speed       = 2.;
          scene.contact.normal_load = load;
          for (BodyParameters *body : {&scene.wheel, &scene.rail})
            body->material = {2 * 82e9 * 1.28, 0.28};
          scene.mesh.elements_across_patch = 14;
        });
      const Resultants &found = run.steady.result;
      BOOST_TEST(found.max_pressure == peak * 1e6,
                 boost::test_tools::tolerance(0.01));
      BOOST_TEST(std::hypot(found.force_x - x, found.force_y + s) <
                 0.005 * run.friction_force());
    }
  BOOST_TEST(n_compared == 3u);
}

BOOST_AUTO_TEST_CASE(an_arc_as_a_profile_is_a_crowned_block)
{
  const double r         = 0.3;
  const auto   creepages = [](SceneParameters &scene) {
    scene.contact.creepages = {5e-4, 1e-3, 0.};
  };
  const SceneRun<3> radii(
    [&](SceneParameters &scene) {
      wheel_on_block(scene);
      scene.rail.lateral_radius = r;
    },
    creepages);
  SceneInMemory run;
  s1002_on_60e1(run.scene);
  creepages(run.scene);
  run.scene.check();
  Situation situation(run.scene);
  situation.frame =
    std::make_shared<const ContactFrame>(pair(cone(0.), arc(0.04, r)),
                                         WheelsetPosition{},
                                         false);
  const SteadyState<3> arcs =
    solve_steady_state<3>(situation, StateDemands(), run.context);
  BOOST_TEST(arcs.result.force_x == radii.steady.result.force_x,
             boost::test_tools::tolerance(5e-3));
  BOOST_TEST(arcs.result.force_y == radii.steady.result.force_y,
             boost::test_tools::tolerance(5e-3));
  BOOST_TEST(arcs.result.max_pressure == radii.steady.result.max_pressure,
             boost::test_tools::tolerance(5e-3));
}

BOOST_AUTO_TEST_CASE(the_track_carries_the_vertical_load)
{
  const SceneRun<3> run([](SceneParameters &scene) { s1002_on_60e1(scene); },
                        [](SceneParameters &scene) {
                          scene.profiles.shift             = 6.2 * mm;
                          scene.contact.normal_load        = {};
                          scene.contact.vertical_load      = 20e3;
                          scene.contact.creepages          = {0., 1e-3, 0.};
                          scene.mesh.elements_across_patch = 10;
                        });
  const Resultants &found = run.steady.result;
  const double      angle = run.situation().frame->angle();
  BOOST_TEST(angle < -0.3);
  BOOST_TEST(found.normal_force * std::cos(angle) -
                 found.force_y * std::sin(angle) ==
               20e3,
             boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(patches_add_up_to_the_state)
{
  const SceneRun<3> run([](SceneParameters &scene) { s1002_on_60e1(scene); },
                        [](SceneParameters &scene) {
                          scene.profiles.shift             = 5.5 * mm;
                          scene.contact.normal_load        = 50e3;
                          scene.contact.creepages          = {1e-3, 0., 0.};
                          scene.mesh.elements_across_patch = 10;
                        });
  const auto        patches = contact_patches(run.steady.pair->trace(),
                                       run.steady.problem,
                                       run.steady.state);
  BOOST_TEST(patches.size() == 2u);
  double load = 0., force = 0., area = 0., heat = 0.;
  for (const ContactPatch &patch : patches)
    {
      load += patch.normal_force;
      force += patch.force_x;
      area += patch.area;
      heat += patch.dissipation;
    }
  const Resultants &whole = run.steady.result;
  BOOST_TEST(patches[0].normal_force > patches[1].normal_force);
  BOOST_TEST(std::abs(patches[0].centre_y - patches[1].centre_y) > 5 * mm);
  BOOST_TEST(load == whole.normal_force, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(force == whole.force_x, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(heat == whole.dissipation, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(area == patch_areas(run.steady.problem, run.steady.state).contact,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_load_beyond_all_bodies_is_refused)
{
  const ContactFrame frame(s1002_on_60e1(), {3 * mm, 0., 0.}, false);
  BOOST_TEST(
    contains(complaint([&]() { profile_patch(frame, steel, 4e6, 0.); }),
             "a load of 4e+06 N"));
  BOOST_TEST(profile_patch(frame, steel, 1e-3, 0.).normal_force == 1e-3,
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(tread_and_flange_at_once_are_refused)
{
  SceneParameters scene;
  s1002_on_60e1(scene);
  scene.profiles.shift      = 6.26 * mm;
  scene.profiles.roll       = {};
  scene.contact.normal_load = 120e3;
  scene.check();
  const std::string said =
    complaint([&]() { estimate_patch(Situation(scene)); });
  BOOST_TEST(contains(said, "Profiles/Lateral shift"));
  BOOST_TEST(contains(said, "degrees"));
}

BOOST_AUTO_TEST_SUITE_END()
