#include <boost/test/unit_test.hpp>

#include <rolling_contact/contact/resultants.h>
#include <rolling_contact/contact/slip_operator.h>
#include <rolling_contact/references/carter.h>
#include <rolling_contact/solvers/contact_solver.h>

#include <cmath>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(solvers)

namespace
{
  const double pi = std::acos(-1.);
  const double mu = 0.3;

  /**
   * Displacement of node i for a unit force at node j of a half-plane, linear
   * tractions between nodes of spacing @p h; half-width, peak pressure and
   * relative radius one, E* = 2. Normal and tangential alike.
   */
  double
  half_plane(const int i, const int j, const double h)
  {
    const auto second_antiderivative = [](const double x) {
      return x == 0. ? 0. : 0.5 * x * x * std::log(std::abs(x)) - 0.75 * x * x;
    };
    const double d = h * (i - j);
    return (-(second_antiderivative(d + h) - 2 * second_antiderivative(d) +
              second_antiderivative(d - h)) /
              h +
            3 * h) /
           pi / h;
  }

  struct Options
  {
    unsigned int     n_elements  = 40;
    double           offset      = 0.3;
    double           creepage    = 0.4; ///< over saturation
    SlipOperatorKind kind        = SlipOperatorKind::calibrated;
    int              flow        = 1;
    double           coupling    = 0.; ///< Dundurs' beta
    bool             friction    = true;
    double           length_unit = 1., pressure_unit = 1.;
  };

  /**
   * Hertz and Carter on half-planes, p0 = a = R = 1, E* = 2, load pi/2.
   */
  ContactProblem
  half_plane_problem(const Options &options)
  {
    const double       h = 2. / options.n_elements * options.length_unit;
    const unsigned int n = 1.6 * options.n_elements;
    Trace              trace;
    for (unsigned int i = 0; i < n; ++i)
      trace.nodes.push_back({{h * (i - 0.5 * (n - 1) + options.offset), 0.}});
    for (unsigned int i = 0; i + 1 < n; ++i)
      trace.cells.push_back({trace.nodes[i],
                             {{trace.nodes[i + 1][0], 1.}},
                             {{{i, 1.}}, {{i + 1, 1.}}}});
    ContactProblem problem;
    problem.n_nodes      = n;
    problem.n_tangential = options.friction ? 1 : 0;
    problem.coupled      = options.coupling != 0.;
    problem.dundurs_beta = options.coupling;
    problem.positions    = trace.nodes;
    problem.H            = contact_matrix(trace, ContactMatrices::lumped, 1.);
    const unsigned int n_blocks = problem.n_tangential + 1;
    problem.W                   = DenseMatrix(n_blocks * n, n_blocks * n);
    const double scale          = 1 / options.pressure_unit;
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          for (unsigned int c = 0; c < n_blocks; ++c)
            problem.W(c * n + i, c * n + j) =
              scale * half_plane(i, j, 2. / options.n_elements);
          if (options.friction)
            {
              // du_t/dx = -beta p, its mirror image in the other block
              const double step   = i == j ? 0. : (i > j ? 0.5 : -0.5);
              problem.W(i, n + j) = -scale * options.coupling * step;
              problem.W(n + j, i) = problem.W(i, n + j);
            }
        }
    for (const auto &node : trace.nodes)
      problem.gap.push_back(node[0] * node[0] / 2 / options.length_unit);
    problem.friction.assign(n, mu);
    if (options.friction)
      problem.slip_operator = SlipOperator(trace,
                                           options.kind,
                                           ContactMatrices::lumped,
                                           options.flow);
    problem.set_creepages(options.creepage * mu, 0., 0.);
    problem.normal_load = pi / 2 * options.length_unit * options.pressure_unit;
    problem.finish();
    return problem;
  }

  struct Solution
  {
    SolverReport report;
    ContactState state;
    Resultants   result;
  };

  Solution
  solve(const ContactProblem &problem,
        const std::string    &solver   = "automatic",
        SolverControls        controls = SolverControls())
  {
    Solution solution;
    solution.report =
      make_contact_solver(solver, controls)->solve(problem, solution.state);
    solution.result = resultants(problem, solution.state);
    return solution;
  }

  double
  carter_force(const double creepage)
  {
    return -(2 * creepage - creepage * creepage);
  }

  double
  force(const Solution &solution)
  {
    return solution.result.force_x / (mu * solution.result.normal_force);
  }
} // namespace

BOOST_AUTO_TEST_CASE(pressure_is_that_of_hertz)
{
  Options options;
  options.friction        = false;
  const Solution solution = solve(half_plane_problem(options));
  BOOST_TEST(solution.report.converged);
  BOOST_TEST(std::abs(solution.result.max_pressure - 1.) < 2e-3);
  BOOST_TEST(std::abs(solution.result.half_width_x - 1.) < 5e-3);
  BOOST_TEST(std::abs(solution.result.normal_force - pi / 2) < 1e-12);
}

BOOST_AUTO_TEST_CASE(the_calibrated_operator_follows_carter_at_any_offset)
{
  for (const double creepage : {0.1, 0.3, 0.5, 0.7})
    for (double offset = 0.; offset < 1.; offset += 0.125)
      {
        Options options;
        options.n_elements      = 48;
        options.offset          = offset;
        options.creepage        = creepage;
        const Solution solution = solve(half_plane_problem(options));
        BOOST_TEST(solution.report.converged);
        BOOST_TEST(std::abs(force(solution) - carter_force(creepage)) < 2e-4);
      }
}

BOOST_AUTO_TEST_CASE(upwind_is_first_order_in_force)
{
  Options options;
  options.kind     = SlipOperatorKind::upwind_2;
  options.creepage = 0.5;
  double previous  = 0.;
  for (const unsigned int n : {24, 48, 96})
    {
      double largest = 0.;
      for (double offset = 0.; offset < 1.; offset += 0.125)
        {
          options.n_elements = n;
          options.offset     = offset;
          largest =
            std::max(largest,
                     std::abs(force(solve(half_plane_problem(options))) -
                              carter_force(0.5)));
        }
      if (previous > 0.)
        BOOST_TEST(std::abs(previous / largest - 2.) < 0.4);
      previous = largest;
    }
}

BOOST_AUTO_TEST_CASE(solvers_agree)
{
  for (const SlipOperatorKind kind : {SlipOperatorKind::upwind_1,
                                      SlipOperatorKind::upwind_2,
                                      SlipOperatorKind::calibrated})
    {
      Options options;
      options.kind                  = kind;
      const ContactProblem problem  = half_plane_problem(options);
      const Solution       active   = solve(problem, "active set");
      const Solution       gradient = solve(problem, "extragradient");
      BOOST_TEST(active.report.converged);
      BOOST_TEST(gradient.report.converged);
      BOOST_TEST(std::abs(force(active) - force(gradient)) < 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(full_slip_and_rest_are_exact)
{
  Options options;
  options.creepage = 1.5;
  BOOST_TEST(std::abs(force(solve(half_plane_problem(options))) + 1.) < 1e-12);
  options.creepage    = 0.;
  const Solution rest = solve(half_plane_problem(options));
  BOOST_TEST(std::abs(force(rest)) < 1e-12);
  BOOST_TEST(rest.result.energy_error() == 0.);
}

BOOST_AUTO_TEST_CASE(friction_dissipates_the_creep_work)
{
  for (const double creepage : {0.2, 0.6, 1.2})
    {
      Options options;
      options.creepage        = creepage;
      const Solution solution = solve(half_plane_problem(options));
      BOOST_TEST(solution.result.dissipation > 0.);
      BOOST_TEST(solution.result.energy_error() < 0.01);
    }
}

BOOST_AUTO_TEST_CASE(reversing_the_flow_mirrors_the_state)
{
  Options options;
  options.coupling           = 0.1;
  const Solution forward     = solve(half_plane_problem(options));
  options.flow               = -1;
  options.offset             = -options.offset;
  options.creepage           = -options.creepage;
  const Solution    backward = solve(half_plane_problem(options));
  const std::size_t n        = forward.state.pressure.size();
  for (std::size_t i = 0; i < n; ++i)
    {
      BOOST_TEST(std::abs(forward.state.pressure[i] -
                          backward.state.pressure[n - 1 - i]) < 1e-8);
      BOOST_TEST(std::abs(forward.state.traction[i] +
                          backward.state.traction[n - 1 - i]) < 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(units_change_nothing)
{
  Options options;
  options.coupling           = 0.1;
  const Solution metres      = solve(half_plane_problem(options));
  options.length_unit        = 1e3;
  options.pressure_unit      = 1e-6;
  const Solution millimetres = solve(half_plane_problem(options));
  BOOST_TEST(std::abs(force(metres) - force(millimetres)) < 1e-11);
  BOOST_TEST(metres.report.iterations == millimetres.report.iterations);
  BOOST_TEST(metres.report.passes == millimetres.report.passes);
}

BOOST_AUTO_TEST_CASE(coupling_calibrated_beats_upwind_over_offsets)
{
  double spread[2];
  for (const SlipOperatorKind kind :
       {SlipOperatorKind::calibrated, SlipOperatorKind::upwind_2})
    {
      double smallest = 1., largest = -1.;
      for (double offset = 0.; offset < 1.; offset += 0.125)
        {
          Options options;
          options.kind            = kind;
          options.coupling        = 0.1;
          options.offset          = offset;
          const Solution solution = solve(half_plane_problem(options));
          BOOST_TEST(solution.report.converged);
          smallest = std::min(smallest, force(solution));
          largest  = std::max(largest, force(solution));
        }
      spread[kind == SlipOperatorKind::upwind_2] = largest - smallest;
    }
  BOOST_TEST(spread[0] < spread[1] / 4);
}

BOOST_AUTO_TEST_CASE(strong_coupling_converges)
{
  for (const double beta : {-0.28, 0.28})
    for (const double creepage : {-0.5, 0., 0.5})
      {
        Options options;
        options.coupling        = beta;
        options.creepage        = creepage;
        const Solution solution = solve(half_plane_problem(options));
        BOOST_TEST(solution.report.converged);
      }
}

BOOST_AUTO_TEST_CASE(few_active_set_solves_at_every_creepage)
{
  for (const unsigned int n : {25, 100, 200})
    for (const double creepage : {1e-7, 1e-3, 0.3, 0.6, 0.9, 0.99, 1.5, 100.})
      {
        Options options;
        options.n_elements      = n;
        options.creepage        = creepage;
        const Solution solution = solve(half_plane_problem(options));
        BOOST_TEST(solution.report.converged);
        BOOST_TEST(solution.report.residual.worst() < 1e-10);
        BOOST_TEST(solution.report.tangential_solves <= 15u);
      }
}

BOOST_AUTO_TEST_CASE(fixed_point_of_the_paper_in_full_slip)
{
  Options options;
  options.creepage = 3.;
  SolverControls controls;
  controls.tolerance = 1e-8;
  const Solution solution =
    solve(half_plane_problem(options), "fixed point", controls);
  BOOST_TEST(solution.report.converged);
  BOOST_TEST(std::abs(force(solution) + 1.) < 1e-7);
  BOOST_TEST(solution.report.history.size() == solution.report.iterations);
}

BOOST_AUTO_TEST_CASE(fixed_point_of_the_paper_does_not_pretend)
{
  Options options;
  options.kind = SlipOperatorKind::galerkin;
  SolverControls controls;
  controls.max_iterations = 500;
  const Solution solution =
    solve(half_plane_problem(options), "fixed point", controls);
  BOOST_TEST(!solution.report.converged);
  BOOST_TEST(!solution.report.reason.empty());
  BOOST_TEST(solution.report.residual.worst() > 1e-6);
}

BOOST_AUTO_TEST_CASE(a_number_that_is_none_is_no_solution)
{
  for (const char *solver : {"automatic", "fixed point"})
    {
      Options        options;
      ContactProblem problem                  = half_plane_problem(options);
      problem.rigid_slip[problem.n_nodes / 2] = std::nan("");
      const Solution solution                 = solve(problem, solver);
      BOOST_TEST(!solution.report.converged);
      BOOST_TEST(!solution.report.reason.empty());
    }
}

BOOST_AUTO_TEST_CASE(separate_patches_are_found)
{
  Options options;
  options.friction       = false;
  ContactProblem problem = half_plane_problem(options);
  for (unsigned int i = 0; i < problem.n_nodes; ++i)
    problem.gap[i] = 0.02 * std::pow(std::sin(4 * problem.positions[i][0]), 2) +
                     0.01 * std::pow(problem.positions[i][0], 2);
  problem.normal_load     = 0.02;
  const Solution solution = solve(problem);
  BOOST_TEST(solution.report.converged);
  unsigned int n_edges = 0;
  for (unsigned int i = 0; i + 1 < problem.n_nodes; ++i)
    n_edges += (solution.state.pressure[i] > 0.) !=
               (solution.state.pressure[i + 1] > 0.);
  BOOST_TEST(n_edges >= 4u);
}

BOOST_AUTO_TEST_CASE(no_contact_and_one_node)
{
  Options        options;
  ContactProblem problem = half_plane_problem(options);
  problem.normal_load.reset();
  problem.approach    = -0.1;
  const Solution open = solve(problem);
  BOOST_TEST(open.report.converged);
  BOOST_TEST(open.result.n_touching == 0u);
  BOOST_TEST(open.result.normal_force == 0.);
  problem.approach =
    1e-9 + *std::min_element(problem.gap.begin(), problem.gap.end());
  const Solution one = solve(problem);
  BOOST_TEST(one.report.converged);
  BOOST_TEST(one.result.n_touching == 1u);
  BOOST_TEST(one.result.normal_force > 0.);
}

BOOST_AUTO_TEST_SUITE_END()
