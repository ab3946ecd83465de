#include "scene_run.h"

#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/contact/tangential_problem.h>
#include <rolling_contact/results/error_bounds.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(edge_law)

namespace
{
  using Change = SceneRun<2>::Change;

  /**
   * T / (mu N) of two discs of steel under 140 kN, changed, on a mesh.
   */
  struct LineContact : public SceneRun<2>
  {
    LineContact(const unsigned int n, const double offset, const Change &change)
      : SceneRun<2>(
          [&](SceneParameters &scene) {
            scene.contact.normal_load        = 140e3;
            scene.contact.creepages.x        = 0.0017;
            scene.mesh.elements_across_patch = n;
            scene.mesh.patch_offset          = offset;
          },
          change)
    {}

    std::size_t n_unresolved() const
    {
      return tangential_problem(steady.problem, steady.state).rows.n_unresolved;
    }
  };

  void flat_rail(SceneParameters &scene, const double depth)
  {
    scene.rail.shape       = "block";
    scene.rail.radius      = 0.;
    scene.rail.block_depth = depth;
  }

  /**
   * The largest error over positions of the mesh, against upwind 2 with 192 and
   * 384 elements, extrapolated over four positions.
   */
  double
  largest_error(const unsigned int n, const Change &change, const double limit)
  {
    double largest = 0.;
    for (const double offset : {0.03, 0.28, 0.53, 0.78})
      largest =
        std::max(largest,
                 std::abs(LineContact(n, offset, change).force_x() - limit));
    return largest;
  }
} // namespace

/**
 * The law took the smooth displacements of thin bodies for those of an edge:
 * these errors were 0.22, 0.065 and 0.064 with 24 elements.
 */
BOOST_AUTO_TEST_CASE(thin_bodies_are_of_second_order)
{
  struct Thin
  {
    Change change;
    double limit;
  };
  const std::array<Thin, 3> bodies{
    {{[](SceneParameters &scene) { flat_rail(scene, 0.004); }, -0.19133},
     {[](SceneParameters &scene) { flat_rail(scene, 0.010); }, -0.37205},
     {[](SceneParameters &scene) { scene.wheel.hub_radius = 0.455; },
      -0.81621}}};
  for (const Thin &body : bodies)
    {
      BOOST_TEST(largest_error(24, body.change, body.limit) < 7e-3);
      BOOST_TEST(largest_error(48, body.change, body.limit) < 8e-4);
    }
}

/**
 * Waves of 12 elements with an amplitude that changes the curvature by two
 * thirds; the error was 1e-2 with 48 elements where only half a wave was in the
 * patch.
 */
BOOST_AUTO_TEST_CASE(resolved_waves_are_of_second_order)
{
  const Change wavy = [](SceneParameters &scene) {
    scene.rail.radius       = 0.8;
    scene.contact.roughness = "2e-6*cos(2*pi*x/6e-3+1)";
  };
  BOOST_TEST(largest_error(24, wavy, -0.57883) < 1e-3);
  BOOST_TEST(largest_error(48, wavy, -0.57883) < 5e-4);
  BOOST_TEST(LineContact(24, 0., wavy).n_unresolved() == 0u);
}

/**
 * On waves of three elements the law means nothing, and was off by 0.2.
 */
BOOST_AUTO_TEST_CASE(unresolved_waves_are_left_to_upwind_2)
{
  const Change rough = [](SceneParameters &scene) {
    scene.rail.radius       = 0.8;
    scene.contact.roughness = "2e-6*cos(2*pi*x/1.26e-3)";
  };
  BOOST_TEST(largest_error(24, rough, -0.54726) < 0.04);
  const LineContact run(24, 0., rough);
  BOOST_TEST(run.n_unresolved() > 0u);
  BOOST_TEST(!error_bounds(run.situation(), run.steady).force);
}

/**
 * A bound is none where none is known, and contains the residual.
 */
BOOST_AUTO_TEST_CASE(bounds_say_what_they_do_not_know)
{
  const LineContact thin(24, 0., [](SceneParameters &scene) {
    flat_rail(scene, 0.003);
  });
  BOOST_TEST(!error_bounds(thin.situation(), thin.steady).force);
  const LineContact loose(24, 0., [](SceneParameters &scene) {
    scene.solver.solver             = "accelerated projection";
    scene.solver.controls.tolerance = 0.1;
  });
  const LineContact exact(24, 0., [](SceneParameters &) {});
  const double      error = std::abs(loose.force_x() - exact.force_x());
  BOOST_TEST(error > 0.01);
  BOOST_TEST(*error_bounds(loose.situation(), loose.steady).force > error);
  BOOST_TEST(*error_bounds(exact.situation(), exact.steady).force < 4e-3);
}

/**
 * Mirror images roll without resistance, and all of the creep work is heat,
 * however little slides: by the slip of the nodes 62 % of it were missing.
 */
BOOST_AUTO_TEST_CASE(friction_turns_the_creep_work_into_heat)
{
  for (const double creepage : {0.0002, 0.0005, 0.001, 0.0025})
    for (const unsigned int n : {16u, 24u})
      {
        const LineContact run(n, 0., [&](SceneParameters &scene) {
          scene.contact.creepages.x = creepage;
        });
        BOOST_TEST(run.steady.result.energy_error() < 2e-3);
      }
}

/**
 * With materials that differ the heat is not the creep work: it is compared
 * with that of 384 elements.
 */
BOOST_AUTO_TEST_CASE(heat_of_different_bodies_converges)
{
  const LineContact run(48, 0., [](SceneParameters &scene) {
    scene.rail.material.young_modulus = 70e9;
  });
  BOOST_TEST(run.steady.result.dissipation == 143.70,
             boost::test_tools::tolerance(0.01));
}

/**
 * Every sliding node slides against its traction, every sticking one rests.
 */
BOOST_AUTO_TEST_CASE(slip_of_the_law_opposes_traction)
{
  const LineContact       run(24, 0.3, [](SceneParameters &) {});
  const ContactProblem   &problem = run.steady.problem;
  const TangentialProblem law  = tangential_problem(problem, run.steady.state);
  const NodalField        slip = law.slip(run.steady.state.traction);
  const auto              states = node_states(law, run.steady.state);
  for (unsigned int i = 0; i < problem.n_nodes(); ++i)
    if (states[i] == NodeState::stick)
      BOOST_TEST(std::abs(slip(0, i)) < 1e-10);
    else if (states[i] == NodeState::slip && law.bound[i] > 0.)
      BOOST_TEST(slip(0, i) * run.steady.state.traction(0, i) < 0.);
}

/**
 * Spin of 3.5 1/m: forces and moment of 12 elements against 24. Upwind 2 where
 * nodes slide gave 1.5e-2.
 */
BOOST_AUTO_TEST_CASE(large_spin_is_of_second_order)
{
  const auto run = [](const unsigned int n) {
    return SceneRun<3>(
      [&](SceneParameters &scene) {
        scene.dimension                  = 3;
        scene.mesh.elements_across_patch = n;
        scene.mesh.growth                = 0.4;
        scene.wheel.lateral_radius       = 0.3;
        scene.rail.lateral_radius        = 0.3;
        scene.contact.normal_load        = 50e3;
        scene.contact.creepages.spin     = 3.5;
      },
      [](SceneParameters &) {});
  };
  const SceneRun<3> coarse = run(12);
  BOOST_TEST(std::abs(coarse.force_y() - 0.4857) < 5e-3);
  BOOST_TEST(coarse.steady.result.energy_error() < 5e-3);
}

BOOST_AUTO_TEST_SUITE_END()
