#include <boost/test/unit_test.hpp>

#include "complaint.h"
#include "scene_run.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/invariants.h>
#include <rolling_contact/contact/patches.h>
#include <rolling_contact/pair/profile_surface.h>
#include <rolling_contact/surfaces/half_space_pressure.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(curved_surface)

namespace
{
  const double mm = 1e-3;

  /** S1002 on 60E1 with a vertical load, creepages of the wheelset. */
  void s1002_on_60e1(SceneParameters &scene)
  {
    scene.dimension                  = 3;
    scene.wheel.radius               = 0.46;
    scene.wheel.lateral_radius       = 0.;
    scene.wheel.width                = 0.1;
    scene.rail.shape                 = "block";
    scene.rail.radius                = 0.;
    scene.rail.width                 = 0.1;
    scene.rail.block_length          = 0.3;
    scene.rail.block_depth           = 0.15;
    scene.contact.vertical_load      = 40e3;
    scene.mesh.elements_across_patch = 10;
    scene.mesh.growth                = 0.8;
    scene.output.body_fields         = false;
    scene.profiles.wheel_profile     = "S1002";
    scene.profiles.rail_profile      = "60E1";
    scene.profiles.roll              = 0.;
    scene.profiles.surface_kind      = Profiles::SurfaceKind::curved;
    scene.profiles.creepage_source =
      ProfileParameters::CreepageSource::kinematics;
  }

  double upwards(const SceneRun<3> &run)
  {
    return run.situation().frame->in_track(run.steady.result.force_y,
                                           run.steady.result.normal_force)[1];
  }
} // namespace

BOOST_AUTO_TEST_CASE(half_spaces_know_the_direction_of_the_load)
{
  // with one share for all the load is that of a plane over the share
  const ContactGrid   grid{20, 20, -3.8 * mm, -3.8 * mm, 0.4 * mm, 0.4 * mm};
  const double        modulus = 1.15e11, share = 0.6, load = 9e3;
  std::vector<double> gap, shares(400, share);
  for (std::size_t j = 0; j < grid.n_y; ++j)
    for (std::size_t i = 0; i < grid.n_x; ++i)
      gap.push_back((std::pow(grid.x(i), 2) + std::pow(grid.y(j), 2)) /
                    (2 * 0.3));
  const auto plane    = half_space_pressure(grid, gap, modulus, load, 0.),
             inclined = half_space_pressure(
               grid, gap, modulus, share * load, 0., shares);
  BOOST_TEST(inclined.load == share * plane.load,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(inclined.approach == plane.approach / share,
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(inclined.pressure[210] == plane.pressure[210],
             boost::test_tools::tolerance(1e-3));
  // with shares of its own, each node is on its own surface
  for (std::size_t i = 0; i < shares.size(); ++i)
    shares[i] = 1 - 0.1 * grid.y(i / grid.n_x) / mm / 4;
  const auto turned = half_space_pressure(grid, gap, modulus, load, 0., shares);
  double     sum    = 0.;
  for (std::size_t i = 0; i < shares.size(); ++i)
    sum += shares[i] * turned.pressure[i] * grid.size_x * grid.size_y;
  BOOST_TEST(sum == load, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(where_normals_hardly_turn_the_surface_is_its_plane)
{
  const auto tread = [](SceneParameters &scene) {
    scene.profiles.shift = 3 * mm;
  };
  const SceneRun<3> curved([](SceneParameters &scene) { s1002_on_60e1(scene); },
                           tread),
    plane([](SceneParameters &scene) { s1002_on_60e1(scene); },
          [&](SceneParameters &scene) {
            tread(scene);
            scene.profiles.surface_kind = Profiles::SurfaceKind::plane;
          });
  const Resultants &one = curved.steady.result, &other = plane.steady.result;
  BOOST_TEST(one.max_pressure == other.max_pressure,
             boost::test_tools::tolerance(3e-3));
  const auto of_curved = curved.situation().frame->in_track(one.force_y,
                                                            one.normal_force),
             of_plane  = plane.situation().frame->in_track(other.force_y,
                                                          other.normal_force);
  BOOST_TEST(
    std::hypot(one.force_x - other.force_x, of_curved[0] - of_plane[0]) <
    0.01 * plane.friction_force());
  BOOST_TEST(of_curved[1] == 40e3, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(solvers_agree_on_a_curved_surface)
{
  const auto with = [](const std::string &solver) {
    return SceneRun<3>([](SceneParameters &scene) { s1002_on_60e1(scene); },
                       [&](SceneParameters &scene) {
                         scene.profiles.shift                 = 6 * mm;
                         scene.solver.solver                  = solver;
                         scene.mesh.elements_across_patch     = 8;
                         scene.solver.controls.max_iterations = 20000;
                       });
  };
  const SceneRun<3> active    = with("automatic"),
                    projected = with("accelerated projection"),
                    fixed     = with("fixed point"); // without an edge law
  for (const SceneRun<3> *run : {&active, &projected, &fixed})
    {
      const bool        is_fixed = run == &fixed;
      const Resultants &found    = run->steady.result,
                       &other    = active.steady.result;
      BOOST_TEST(upwards(*run) == 40e3, boost::test_tools::tolerance(1e-8));
      BOOST_TEST(std::hypot(found.force_x - other.force_x,
                            found.force_y - other.force_y) <
                 (is_fixed ? 1e-2 : 1e-6) * active.friction_force());
      BOOST_TEST(run->steady.state.approach == active.steady.state.approach,
                 boost::test_tools::tolerance(is_fixed ? 1e-3 : 1e-6));
      const Invariants broken =
        invariants(run->steady.problem, run->steady.state);
      BOOST_TEST(broken.overlap < 1e-6);
      BOOST_TEST(broken.cone < 1e-6);
      BOOST_TEST(broken.load < 1e-6);
    }
}

BOOST_AUTO_TEST_CASE(tread_and_flange_are_one_state)
{
  // a rail relieved at its gauge corner: the shoulder and the flange touch
  const auto both = [](SceneParameters &scene, const bool is_left) {
    scene.prm_folder                 = std::string(TEST_DATA) + "/../../prm";
    scene.profiles.rail_profile      = "profiles/side_worn_rail.txt";
    scene.profiles.is_left           = is_left;
    scene.profiles.roll              = {}; // both wheels touch
    scene.profiles.shift             = is_left ? -6.25 * mm : 6.25 * mm;
    scene.contact.vertical_load      = 80e3;
    scene.mesh.elements_across_patch = 8;
  };
  const auto run = [&](const bool is_left) {
    return std::make_unique<SceneRun<3>>(
      [](SceneParameters &scene) { s1002_on_60e1(scene); },
      [&](SceneParameters &scene) { both(scene, is_left); });
  };
  const auto                    right = run(false), left = run(true);
  const Profiles::ContactFrame &frame = *right->situation().frame;
  BOOST_TEST(upwards(*right) == 80e3, boost::test_tools::tolerance(1e-8));
  const auto patches = contact_patches(right->steady.pair->trace(),
                                       right->steady.problem,
                                       right->steady.state);
  BOOST_REQUIRE(patches.size() == 2u);
  const double turn = frame.surface(patches[0].centre_y).angle -
                      frame.surface(patches[1].centre_y).angle;
  BOOST_TEST(std::abs(turn) > 0.7);
  double across = 0., up = 0., pressed = 0.;
  for (const ContactPatch &patch : patches)
    {
      BOOST_TEST(patch.normal_force > 0.05 * 80e3);
      BOOST_TEST(std::hypot(patch.force_x, patch.force_y) <
                 0.3 * patch.normal_force * (1 + 1e-9));
      const auto in_track = frame.in_track(patch.in_plane.y, patch.in_plane.z);
      across += in_track[0];
      up += in_track[1];
      pressed += patch.normal_force;
    }
  BOOST_TEST(up == 80e3, boost::test_tools::tolerance(1e-8));
  const Resultants &one = right->steady.result, &other = left->steady.result;
  BOOST_TEST(one.traction_coefficient * pressed == one.tangential_force,
             boost::test_tools::tolerance(1e-9));
  // rigid slip at the nodes, along their own tangents
  const ContactProblem &problem = right->steady.problem;
  const NodalField      slip    = problem.rigid_slip();
  const Creepages      &creep   = problem.loads.creepages;
  for (unsigned int i = 0; i < problem.n_nodes(); i += 7)
    {
      const auto [x, s]        = problem.operators.positions()[i];
      const auto [y, z, angle] = frame.surface(s);
      const double normal      = problem.operators.frames().nodes[i].angle;
      // of steel on steel half-way between the slopes of rail and wheel
      const auto arc_length = frame.wheel_arc_length(s);
      BOOST_TEST_REQUIRE(arc_length.has_value());
      const double wheel =
        frame.wheel_on_rail().wheel_profile().at(*arc_length).angle -
        frame.angle();
      if (std::abs(wheel - angle) < 0.09)
        BOOST_TEST(std::abs(normal - (angle + wheel) / 2) < 1e-3);
      // as the radius there is larger
      BOOST_TEST(std::abs(slip(0, i) - creep.x + frame.spin_of_cone() * y -
                          frame.slip_beyond_spin(s)) < 1e-11);
      // behind the contact the wheel goes up
      const double r    = frame.origin().rolling_radius,
                   down = -x / r * std::cos(frame.angle() - frame.roll());
      BOOST_TEST(std::abs(slip(1, i) -
                          (creep.y + creep.spin * x) * std::cos(normal) -
                          down * std::sin(normal)) < 1e-12);
      BOOST_TEST(problem.operators.approach_share(i) ==
                   std::cos(normal + frame.angle()),
                 boost::test_tools::tolerance(1e-12));
    }
  // the narrower patch has some rows of nodes across
  std::set<long> rows;
  for (const unsigned int i : patches[1].nodes)
    rows.insert(std::lround(1e8 * problem.operators.positions()[i][1]));
  BOOST_TEST(rows.size() >= 5u);
  // the other side is its mirror image
  BOOST_TEST(other.normal_force == one.normal_force,
             boost::test_tools::tolerance(1e-5));
  BOOST_TEST(other.force_x == one.force_x, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(other.force_y == -one.force_y, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(other.spin_moment == -one.spin_moment,
             boost::test_tools::tolerance(1e-4));
  const auto of_left =
    left->situation().frame->in_track(other.force_y, other.normal_force);
  BOOST_TEST(of_left[0] == -across, boost::test_tools::tolerance(1e-4));
  // one plane has no answer
  SceneInMemory plane;
  s1002_on_60e1(plane.scene);
  both(plane.scene, false);
  plane.scene.profiles.surface_kind = Profiles::SurfaceKind::plane;
  plane.scene.check();
  BOOST_TEST(contains(complaint([&]() {
                        solve_steady_state<3>(plane.situation(),
                                              StateDemands(),
                                              plane.context);
                      }),
                      "Contact surface = curved"));
}

BOOST_AUTO_TEST_CASE(the_narrowest_patch_is_resolved)
{
  // rails inclined by 1:20: crown, shoulder and gauge corner
  SceneInMemory run;
  s1002_on_60e1(run.scene);
  run.scene.profiles.inclination  = "1/20";
  run.scene.profiles.shift        = 6.1 * mm;
  run.scene.profiles.roll         = {};
  run.scene.contact.vertical_load = 80e3;
  run.scene.check();
  const PatchEstimate patch = estimate_patch(run.situation());
  BOOST_TEST(patch.narrowest_y > 0.);
  BOOST_TEST(patch.narrowest_y < 0.5 * patch.half_width_y);
  const Grading<3> grading =
    make_grading<3>(run.situation(), StateDemands(), patch, 12, 0.);
  BOOST_TEST(6 * grading.element_size_y <= 2 * patch.narrowest_y * (1 + 1e-12));
  BOOST_TEST(6 * grading.element_size_x <= 2 * patch.shortest_x * (1 + 1e-12));
}

BOOST_AUTO_TEST_CASE(true_sections_are_pressed_along_their_normals)
{
  const SceneRun<3> run([](SceneParameters &scene) { s1002_on_60e1(scene); },
                        [](SceneParameters &scene) {
                          scene.profiles.shift             = 6.2 * mm;
                          scene.profiles.true_sections     = true;
                          scene.wheel.hub_radius           = 0.095;
                          scene.rail.block_length          = 0.4;
                          scene.contact.vertical_load      = 20e3;
                          scene.mesh.elements_across_patch = 6;
                          scene.output.body_fields = true; // keeps factors
                        });
  BOOST_TEST(upwards(run) == 20e3, boost::test_tools::tolerance(1e-8));
  const Profiles::ContactFrame &frame = *run.situation().frame;
  // the bodies' own surfaces have the slopes of the nodes, the wheel mirrored
  for (const double s : {-2 * mm, 1 * mm, 3 * mm})
    for (const Side side : both_sides)
      {
        const auto   shape = run.situation().body(side).body_shape();
        const double step  = 1e-5,
                     rise  = (shape->surface_height(0., s + step) -
                             shape->surface_height(0., s - step)) /
                            (2 * step),
                     sine = std::sin(frame.surface(s).angle);
        // the wheel faces it but for the gap that opens
        BOOST_TEST(std::abs(rise - (side == Side::rail ? -sine : sine)) <
                   (side == Side::rail ? 1e-4 : 0.06));
      }
  // W along normals and tangents, from that of the bodies in their axes
  const auto       &pair     = *run.steady.pair;
  const auto       &nodes    = run.steady.problem.operators.frames().nodes;
  const std::size_t n        = nodes.size();
  DenseMatrix       expected = DenseMatrix::Zero(n, n),
              tangential     = DenseMatrix::Zero(n, n);
  for (const Side side : both_sides)
    {
      const DenseMatrix W =
        pair.bodies().body(side)->compliance(pair.interface().nodes[side],
                                             {0, 1, 2});
      const double mirror = side == Side::rail ? 1. : -1.;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double ci = std::cos(nodes[i].angle),
                         si = mirror * std::sin(nodes[i].angle),
                         cj = std::cos(nodes[j].angle),
                         sj = mirror * std::sin(nodes[j].angle);
            const double yy = W(n + i, n + j), yz = W(n + i, 2 * n + j),
                         zy = W(2 * n + i, n + j), zz = W(2 * n + i, 2 * n + j);
            expected(i, j) +=
              si * yy * sj + si * yz * cj + ci * zy * sj + ci * zz * cj;
            tangential(i, j) +=
              ci * yy * cj - ci * yz * sj - si * zy * cj + si * zz * sj;
          }
    }
  const DenseMatrix W    = run.steady.problem.operators.W().dense();
  double            size = 0., off = 0.;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      {
        size = std::max(size, std::abs(expected(i, j)));
        off  = std::max({off,
                         std::abs(W(2 * n + i, 2 * n + j) - expected(i, j)),
                         std::abs(W(n + i, n + j) - tangential(i, j))});
      }
  BOOST_TEST(off < 1e-9 * size);
}

BOOST_AUTO_TEST_CASE(without_friction_nodes_are_turned_as_well)
{
  const SceneRun<3> run([](SceneParameters &scene) { s1002_on_60e1(scene); },
                        [](SceneParameters &scene) {
                          scene.profiles.shift               = 6.2 * mm;
                          scene.profiles.true_sections       = true;
                          scene.wheel.hub_radius             = 0.095;
                          scene.rail.block_length            = 0.4;
                          scene.contact.vertical_load        = 20e3;
                          scene.contact.friction_coefficient = 0.;
                          scene.mesh.elements_across_patch   = 6;
                        });
  BOOST_TEST(upwards(run) == 20e3, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(std::abs(run.steady.result.force_x) < 1e-6);
  BOOST_TEST(run.steady.result.tangential_force < 1e-6);
}

BOOST_AUTO_TEST_CASE(heat_is_the_work_of_slip_on_the_curved_surface)
{
  // where all slides the energy of friction is that of the rigid slip
  const SceneRun<3> run([](SceneParameters &scene) { s1002_on_60e1(scene); },
                        [](SceneParameters &scene) {
                          scene.profiles.shift = 6.1 * mm;
                          scene.profiles.yaw   = 0.02;
                        });
  BOOST_TEST(run.steady.result.traction_coefficient > 0.29);
  BOOST_TEST(run.steady.result.energy_error() < 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
