#include "disc_on_block.h"
#include <Eigen/Eigenvalues>

#include <rolling_contact/contact/halved_problem.h>
#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/solvers/contact_solver.h>
#include <rolling_contact/solvers/newton_step.h>
#include <rolling_contact/solvers/pressure_on_grid.h>

#include <cmath>
#include <functional>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(grid_contact)

namespace
{
  using Change = std::function<void(SceneParameters &)>;

  /**
   * A steel disc on a crowned block of another material, split, with few
   * elements, whose compliance is a matrix; and the same problem on a grid.
   */
  struct DiscOnBlock : public SceneInMemory
  {
    explicit DiscOnBlock(const Change &change = [](SceneParameters &) {})
    {
      set_disc_on_block(scene);
      scene.rail.material.young_modulus = 120e9;
      scene.contact.creepages           = {0.0006, 0.001, 0.2};
      scene.mesh.elements_across_patch  = 10;
      scene.mesh.compliance             = Compliance::split;
      scene.output.body_fields          = false;
      change(scene);
      scene.check();
      StateDemands demands;
      demands.pair.bulk_errors = true;
      steady  = solve_steady_state<3>(situation(), demands, context);
      on_grid = problem_on_grid();
    }

    ContactProblem problem_on_grid() const
    {
      const auto                              &pair = *steady.pair;
      std::vector<ElasticBody<3>::SurfaceNode> nodes(pair.trace().nodes.size());
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (unsigned int d = 0; d < 2; ++d)
          nodes[i].position[d] = pair.trace().nodes[i][d];
      std::vector<unsigned int> components{2};
      if (steady.problem.n_tangential() > 0)
        components = {0, 1, 2};
      auto wheel =
             pair.bodies().body(Side::wheel)->grid_influence(nodes, components),
           rail =
             pair.bodies().body(Side::rail)->grid_influence(nodes, components);
      wheel->mirror();
      rail->add(*wheel);
      ContactProblem problem =
        pair.contact_problem(situation().contact,
                             ContactCompliance(
                               std::make_shared<const GridCompliance>(*rail)));
      problem.loads = steady.problem.loads;
      return problem;
    }

    SteadyState<3> steady;
    ContactProblem on_grid;
  };

  std::vector<double> some_values(const std::size_t n)
  {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i)
      values.push_back(std::sin(1. + 0.7 * i) + 0.3 * std::cos(0.01 * i * i));
    return values;
  }

  double largest(const std::vector<double> &values)
  {
    return as_vector(values).cwiseAbs().maxCoeff();
  }

  double difference(const std::vector<double> &one,
                    const std::vector<double> &other)
  {
    return largest(sum(one, -1., other)) / largest(other);
  }

  const Change frictionless = [](SceneParameters &scene) {
    scene.contact.friction_coefficient = 0.;
    scene.contact.creepages            = {};
  };
} // namespace

BOOST_AUTO_TEST_CASE(a_grid_has_the_entries_and_products_of_the_matrix)
{
  for (const Change &change : {Change([](SceneParameters &) {}), frictionless})
    {
      const DiscOnBlock        scene(change);
      const ContactCompliance &matrix = scene.steady.problem.operators.W(),
                              &grid   = scene.on_grid.operators.W();
      BOOST_TEST_REQUIRE(!matrix.on_grid());
      BOOST_TEST_REQUIRE(grid.on_grid());
      const DenseMatrix W = matrix.dense();
      BOOST_TEST((W - grid.dense()).cwiseAbs().maxCoeff() <
                 1e-13 * W.cwiseAbs().maxCoeff());
      double error = 0.;
      for (std::size_t i = 0; i < grid.rows(); i += 7)
        for (std::size_t j = 0; j < grid.rows(); ++j)
          error = std::max(error, std::abs(grid(i, j) - W(i, j)));
      BOOST_TEST(error < 1e-13 * W.cwiseAbs().maxCoeff());
      const std::size_t N = scene.on_grid.n_nodes();
      const auto        f = some_values(grid.rows());
      BOOST_TEST(difference(grid * f, W * f) < 1e-13);
      const std::vector<double> part(f.begin(), f.begin() + N);
      for (std::size_t of = 0; of < grid.rows(); of += N)
        for (std::size_t by = 0; by < grid.rows(); by += N)
          BOOST_TEST(difference(grid.product(of, by, N, part),
                                block_product(W, of, by, N, part)) < 1e-12);
    }
}

/** But for what moves all nodes alike, which slips do not see. */
BOOST_AUTO_TEST_CASE(slips_are_those_of_the_matrix)
{
  const DiscOnBlock scene;
  const auto       &matrix = scene.steady.problem.operators,
             &grid         = scene.on_grid.operators;
  NodalField traction(matrix.n_nodes(), 2);
  const auto values = some_values(traction.values().size());
  std::copy(values.begin(), values.end(), traction.begin());
  const std::vector<double> pressure = some_values(matrix.n_nodes());
  for (const auto &[one, other] :
       {std::pair(grid.distortion_of_traction(traction),
                  matrix.distortion_of_traction(traction)),
        {grid.distortion_of_pressure(pressure),
         matrix.distortion_of_pressure(pressure)}})
    {
      const auto B1 = [&](const NodalField &w) {
        return matrix.slip_operator().rows().multiply(w.values());
      };
      BOOST_TEST(difference(B1(one), B1(other)) < 1e-11);
    }
  BOOST_TEST(grid.tangential_norm() == matrix.tangential_norm(),
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(grid.normal_norm() == matrix.normal_norm(),
             boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(states_are_those_of_the_matrix)
{
  const auto given_approach = [](SceneParameters &scene) {
    scene.contact.normal_load.reset();
    scene.contact.approach = 60e-6;
  };
  const auto sliding = [](SceneParameters &scene) {
    scene.contact.creepages = {0., 0.02, 0.};
  };
  const auto alike = [](SceneParameters &scene) {
    scene.rail.material.young_modulus = scene.wheel.material.young_modulus;
  };
  for (const Change &change : {Change([](SceneParameters &) {}),
                               Change(given_approach),
                               Change(sliding),
                               Change(alike),
                               frictionless})
    {
      const DiscOnBlock scene(change);
      ContactState      state;
      const auto        report =
        make_contact_solver("automatic", scene.situation().solver.controls)
          ->solve(scene.on_grid, state);
      BOOST_TEST(report.converged);
      BOOST_TEST(!report.used_fallback);
      const ContactState &expected = scene.steady.state;
      BOOST_TEST(difference(state.pressure, expected.pressure) < 1e-8);
      BOOST_TEST(state.approach == expected.approach,
                 boost::test_tools::tolerance(1e-10));
      if (scene.on_grid.n_tangential() > 0)
        BOOST_TEST(difference(state.traction.values(),
                              expected.traction.values()) < 1e-7);
    }
}

/** What the transforms divide by stands in for W on whatever nodes. */
BOOST_AUTO_TEST_CASE(the_preconditioner_is_close_to_the_inverse)
{
  const DiscOnBlock         scene;
  const auto               &grid = *scene.on_grid.operators.W().on_grid();
  const std::size_t         N = scene.on_grid.n_nodes(), first = 2 * N;
  const std::vector<double> gap = scene.on_grid.loads.gap;
  std::vector<std::size_t>  nodes;
  for (std::size_t i = 0; i < N; ++i)
    if (gap[i] < 60e-6)
      nodes.push_back(i);
  DenseMatrix M(N, N), W(N, N);
  for (std::size_t j = 0; j < N; ++j)
    {
      std::vector<double> unit(N, 0.);
      unit[j]  = 1.;
      M.col(j) = as_vector(grid.forces_for(unit, 2));
      for (std::size_t i = 0; i < N; ++i)
        W(i, j) = grid(first + i, first + j);
    }
  const DenseMatrix product = DenseMatrix(M(nodes, nodes)) * W(nodes, nodes);
  const Eigen::VectorXcd values = product.eigenvalues();
  BOOST_TEST_MESSAGE("eigenvalues from " << values.real().minCoeff() << " to "
                                         << values.real().maxCoeff());
  BOOST_TEST(nodes.size() > N / 2);
  BOOST_TEST(values.real().minCoeff() > 0.95);
  BOOST_TEST(values.real().maxCoeff() < 3.);
}

/** The solution on active nodes: no gap, no force beside them, the load. */
BOOST_AUTO_TEST_CASE(pressure_closes_the_gaps_of_active_nodes)
{
  const DiscOnBlock   scene(frictionless);
  const auto         &problem = scene.on_grid;
  std::vector<bool>   active;
  ContactState        state = open_state(problem);
  std::vector<double> gap   = problem.loads.gap;
  for (std::size_t i = 0; i < gap.size(); ++i)
    active.push_back(gap[i] < 30e-6);
  BOOST_TEST_REQUIRE(solve_pressure_on_grid(problem, gap, active, state));
  BOOST_TEST(problem.operators.load(state.pressure) == 50e3,
             boost::test_tools::tolerance(1e-12));
  const auto open = normal_gap(problem, state);
  for (std::size_t i = 0; i < gap.size(); ++i)
    if (active[i])
      BOOST_TEST(std::abs(open[i]) < 1e-12 * state.approach);
    else
      BOOST_TEST(state.pressure[i] == 0.);
}

/** Iterations give the step of the factors, to what is asked of them. */
BOOST_AUTO_TEST_CASE(newton_steps_are_those_of_the_matrix)
{
  const DiscOnBlock  scene;
  const ContactState state    = scene.steady.state;
  const auto         friction = [&](const ContactProblem &problem) {
    return tangential_problem(problem, state);
  };
  const auto matrix = friction(scene.steady.problem),
             grid   = friction(scene.on_grid);
  const TouchingFriction by_factors(matrix), by_iterations(grid);
  BOOST_TEST(!by_factors.is_on_grid());
  BOOST_TEST(by_iterations.is_on_grid());
  std::vector<double> traction = by_factors.gathered(state.traction);
  for (double &q : traction)
    q *= 0.9;
  BOOST_TEST(difference(by_iterations.slip(traction),
                        by_factors.slip(traction)) < 1e-10);
  BOOST_TEST(by_iterations.residual(traction) == by_factors.residual(traction),
             boost::test_tools::tolerance(1e-9));
  const double        rho = 0.3 / by_factors.norm;
  std::vector<double> one, other;
  BOOST_TEST_REQUIRE(newton_step(by_factors, traction, rho, 0., one));
  BOOST_TEST_REQUIRE(newton_step(by_iterations, traction, rho, 1e-10, other));
  BOOST_TEST(difference(other, one) < 1e-8);
}

/** Hats of twice the size, where all of their nodes are there. */
BOOST_AUTO_TEST_CASE(half_of_a_grid_is_half_of_its_matrix)
{
  const DiscOnBlock scene;
  for (const std::array<unsigned int, 2> odd :
       {std::array<unsigned int, 2>{{0, 0}}, {{1, 0}}, {{1, 1}}})
    {
      const auto half = [&](const ContactProblem &problem) {
        return halved_problem(problem,
                              scene.steady.pair->trace(),
                              ContactMatrices::lumped,
                              1.,
                              odd);
      };
      const auto matrix = half(scene.steady.problem),
                 grid   = half(scene.on_grid);
      BOOST_TEST_REQUIRE(matrix.has_value());
      BOOST_TEST_REQUIRE(grid.has_value());
      const auto &one   = grid->problem.operators,
                 &other = matrix->problem.operators;
      BOOST_TEST_REQUIRE(one.W().on_grid());
      const std::size_t N = one.n_nodes();
      const double      whole =
        *std::max_element(one.areas().begin(), one.areas().end());
      std::vector<std::size_t> inner;
      for (std::size_t i = 0; i < N; ++i)
        if (one.areas()[i] > 0.99 * whole)
          inner.push_back(i);
      BOOST_TEST(inner.size() > N / 4);
      const double size  = other.W().dense().cwiseAbs().maxCoeff();
      double       error = 0.;
      for (const std::size_t i : inner)
        for (const std::size_t j : inner)
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              error = std::max(error,
                               std::abs(one.W()(a * N + i, b * N + j) -
                                        other.W()(a * N + i, b * N + j)));
      BOOST_TEST(error < 1e-12 * size);
    }
}

BOOST_AUTO_TEST_SUITE_END()
