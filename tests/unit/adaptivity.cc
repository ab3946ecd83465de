#include <boost/test/unit_test.hpp>

#include "scene_run.h"

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/operators.h>
#include <rolling_contact/state/adaptive_levels.h>

#include <algorithm>
#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(adaptivity)

namespace
{
  void standard_2d(SceneParameters &scene)
  {
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      {
        body->radius     = 0.46;
        body->hub_radius = 0.08;
        body->thickness  = 0.02;
      }
    scene.contact.approach           = 0.22e-3;
    scene.contact.creepages.x        = 0.0017;
    scene.contact.slip_operator      = SlipOperatorKind::upwind_2;
    scene.mesh.elements_across_patch = 16;
    scene.mesh.growth                = 0.3;
    scene.mesh.target_change         = 0.;
  }

  void standard_3d(SceneParameters &scene)
  {
    standard_2d(scene);
    scene.dimension = 3;
    for (BodyParameters *body : {&scene.wheel, &scene.rail})
      {
        body->lateral_radius = 0.3;
        body->width          = 0.1;
      }
    scene.contact.approach           = 0.07e-3;
    scene.contact.creepages.x        = 0.;
    scene.contact.creepages.y        = 0.003;
    scene.mesh.elements_across_patch = 6;
    scene.mesh.candidate_zone        = 1.25;
    scene.mesh.growth                = 0.6;
  }

  /**
   * All levels of a scene, in memory.
   */
  template <int dim>
  struct LevelRun : public SceneInMemory
  {
    LevelRun(const typename SceneRun<dim>::Change &standard,
             const typename SceneRun<dim>::Change &change)
    {
      standard(scene);
      change(scene);
      scene.check();
      last = AdaptiveLevels<dim>(Situation(scene), StateDemands(), context)
               .run([&](const SteadyState<dim> &level) {
                 BOOST_TEST(level.solver.converged);
                 n_nodes.push_back(level.problem.n_nodes());
               });
    }

    SteadyState<dim>          last;
    std::vector<unsigned int> n_nodes;
  };
} // namespace

/**
 * Three levels whose errors shrink by the same factor point to the exact limit.
 */
BOOST_AUTO_TEST_CASE(geometric_levels_have_an_exact_limit)
{
  LevelHistory history;
  BOOST_TEST(!history.change().has_value());
  for (const double error : {0.08, 0.02, 0.005})
    {
      LevelValues level;
      level.values = {{100., 16. * (1 + error), 12. * (1 + error), 1e-4}};
      level.friction_force = 30.;
      history.add(level);
    }
  BOOST_TEST(*history.change() == 20. * 0.015 / 30,
             boost::test_tools::tolerance(1e-12));
  const auto limit = history.limit();
  BOOST_TEST(limit->limit.values[LevelValues::force_x] == 16.,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(limit->limit.values[LevelValues::force_y] == 12.,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(limit->value_error == 20. * 0.005 / 30,
             boost::test_tools::tolerance(1e-10));
}

/**
 * Meshes are made and solved on as long as states ask for others, ten at most.
 */
BOOST_AUTO_TEST_CASE(meshes_end_where_one_fits_or_at_ten)
{
  for (const unsigned int n_needed : {1u, 3u, 10u, 11u})
    {
      unsigned int n_solved = 0, n_made = 1;
      const bool   fits = solve_on_fitting_mesh(
        [&](const unsigned int k) {
          BOOST_TEST(k == n_solved);
          BOOST_TEST(n_made == n_solved + 1);
          ++n_solved;
        },
        [&](const unsigned int k) {
          BOOST_TEST(k + 1 == n_solved);
          const bool another = n_solved < n_needed;
          n_made += another;
          return another;
        });
      BOOST_TEST(fits == (n_needed <= 10));
      BOOST_TEST(n_solved == std::min(n_needed, 10u));
    }
}

/**
 * Where elements of different size meet, balanced row sums give the nodal
 * forces of a linear pressure as the consistent matrix does, in 2D and through
 * hanging nodes; plain row sums would not.
 */
BOOST_AUTO_TEST_CASE(balanced_lumping_is_exact_on_linear_fields)
{
  const auto worst = [](const Trace &trace) {
    std::vector<double> field;
    for (const auto &node : trace.nodes)
      field.push_back(1 + 300 * node[0] - 200 * node[1]);
    const auto lumped =
      contact_matrix(trace, ContactMatrices::balanced, 0.02).multiply(field);
    const auto consistent =
      contact_matrix(trace, ContactMatrices::consistent, 0.02).multiply(field);
    const auto border = trace.border_nodes();
    double     error = 0., largest = 0.;
    for (std::size_t i = 0; i < field.size(); ++i)
      if (!border[i])
        {
          error   = std::max(error, std::abs(lumped[i] - consistent[i]));
          largest = std::max(largest, std::abs(consistent[i]));
        }
    return error / largest;
  };
  const auto two_levels = [](SceneParameters &scene) {
    scene.mesh.adaptive_levels = 1;
  };
  BOOST_TEST(worst(LevelRun<2>(standard_2d, two_levels).last.pair->trace()) <
             1e-12);
  BOOST_TEST(worst(LevelRun<3>(standard_3d, two_levels).last.pair->trace()) <
             1e-12);
}

/**
 * The marked cells are where the state says: at the ends of the patch, leading
 * before trailing, and at the end of the stick zone.
 */
BOOST_AUTO_TEST_CASE(marks_are_at_rim_and_stick_border)
{
  const SceneRun<2> run(standard_2d, [](SceneParameters &) {});
  const auto       &trace = run.steady.pair->trace();
  const auto        marks =
    refinement_marks(trace, run.steady.problem, run.steady.state);
  const double size       = run.steady.grading.element_size_x;
  const double half_width = run.steady.result.half_width_x;
  // end of the stick zone, from the leading edge: 2 c, c/a = 1 - z
  const double border = -half_width + 2 * half_width * 0.6919;
  for (std::size_t k = 0; k < marks.size(); ++k)
    {
      const double x = (trace.cells[k].lower[0] + trace.cells[k].upper[0]) / 2;
      if (marks[k] == RefinementMark::leading_rim)
        BOOST_TEST((x > -half_width - size && x < -half_width + 3 * size));
      else if (marks[k] == RefinementMark::trailing_rim)
        BOOST_TEST((x < half_width + size && x > half_width - 3 * size));
      else if (marks[k] == RefinementMark::stick_border)
        BOOST_TEST(std::abs(x - border) < 3 * size);
    }
  for (const auto mark : {RefinementMark::leading_rim,
                          RefinementMark::stick_border,
                          RefinementMark::trailing_rim})
    BOOST_TEST(std::count(marks.begin(), marks.end(), mark) >= 3);
}

/**
 * Bodies of different shape and size stay matched through all levels, and the
 * rim's error of the peak pressure shrinks.
 */
BOOST_AUTO_TEST_CASE(different_bodies_stay_matched)
{
  const LevelRun<2> run(standard_2d, [](SceneParameters &scene) {
    scene.rail.shape           = "block";
    scene.rail.radius          = 0.;
    scene.rail.block_length    = 0.9;
    scene.rail.block_depth     = 0.37;
    scene.mesh.adaptive_levels = 3;
  });
  BOOST_TEST(run.n_nodes.size() == 4u);
  for (std::size_t k = 1; k < run.n_nodes.size(); ++k)
    BOOST_TEST(run.n_nodes[k] > run.n_nodes[k - 1]);

  const LevelRun<3> crowned(standard_3d, [](SceneParameters &scene) {
    scene.rail.shape           = "block";
    scene.rail.radius          = 0.;
    scene.rail.block_length    = 0.2;
    scene.rail.block_depth     = 0.11;
    scene.mesh.adaptive_levels = 1;
  });
  BOOST_TEST(crowned.n_nodes.size() == 2u);
}

/**
 * A state carried over to the mesh it comes from is itself, and a refined
 * twin's residual starts near that of the coarse state.
 */
BOOST_AUTO_TEST_CASE(transfer_keeps_the_state)
{
  const SceneRun<2> run(standard_2d, [](SceneParameters &) {});
  const auto        state = transferred_state(run.steady, run.steady.problem);
  BOOST_TEST(state.approach == run.steady.state.approach);
  for (std::size_t i = 0; i < state.pressure.size(); ++i)
    {
      BOOST_TEST(state.pressure[i] == run.steady.state.pressure[i]);
      BOOST_TEST(state.traction(0, i) == run.steady.state.traction(0, i));
    }
}

/**
 * Levels end before the budget, urgent marks first, and a budget below the
 * first mesh is refused before meshing.
 */
BOOST_AUTO_TEST_CASE(the_budget_holds)
{
  const LevelRun<2> run(standard_2d, [](SceneParameters &scene) {
    scene.mesh.adaptive_levels     = 5;
    scene.mesh.contact_node_budget = 40;
  });
  BOOST_TEST(run.n_nodes.size() > 1u);
  BOOST_TEST(run.n_nodes.back() <= 40u);
  BOOST_TEST(run.said.str().find("budget") != std::string::npos);

  const auto too_small = []() {
    LevelRun<2>(standard_2d, [](SceneParameters &scene) {
      scene.mesh.adaptive_levels     = 1;
      scene.mesh.contact_node_budget = 10;
    });
  };
  BOOST_CHECK_EXCEPTION(too_small(), InputError, [](const InputError &error) {
    return std::string(error.what()).find("Contact node budget") !=
           std::string::npos;
  });
}

/**
 * Halving the contact zone is the same as asking for twice the elements.
 */
BOOST_AUTO_TEST_CASE(uniform_levels_are_twice_the_elements)
{
  const LevelRun<2> levels(standard_2d, [](SceneParameters &scene) {
    scene.mesh.adaptive_levels = 1;
    scene.mesh.level_marking   = LevelMarking::uniform;
  });
  const SceneRun<2> direct(standard_2d, [](SceneParameters &scene) {
    scene.mesh.elements_across_patch = 32;
  });
  BOOST_TEST(levels.last.result.force_x == direct.steady.result.force_x,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(levels.last.grading.elements_across() == 32u);
}

BOOST_AUTO_TEST_SUITE_END()
