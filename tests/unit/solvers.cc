#include <boost/test/unit_test.hpp>

#include "half_plane.h"

#include <rolling_contact/references/carter.h>

#include <cmath>

using namespace RollingContact;
using namespace HalfPlane;

BOOST_AUTO_TEST_SUITE(solvers)

BOOST_AUTO_TEST_CASE(pressure_is_that_of_hertz)
{
  Options options;
  options.friction        = false;
  const Solution solution = solve(half_plane_problem(options));
  BOOST_TEST(solution.report.converged);
  BOOST_TEST(std::abs(solution.result.max_pressure - 1.) < 2e-3);
  // edges are recovered as those of finite elements, which these are not
  BOOST_TEST(std::abs(solution.result.half_width_x - 1.) < 8e-3);
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
      const Solution accelerated    = solve(problem, "accelerated projection");
      BOOST_TEST(active.report.converged);
      BOOST_TEST(gradient.report.converged);
      BOOST_TEST(accelerated.report.converged);
      BOOST_TEST(std::abs(force(active) - force(gradient)) < 1e-8);
      BOOST_TEST(std::abs(force(active) - force(accelerated)) < 1e-8);
      // a product with W for each step, and two of the extragradient
      BOOST_TEST(accelerated.report.iterations <
                 1.5 * gradient.report.iterations);
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
      BOOST_TEST(std::abs(forward.state.traction(0, i) +
                          backward.state.traction(0, n - 1 - i)) < 1e-8);
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

BOOST_AUTO_TEST_CASE(a_rigid_motion_far_larger_than_the_strain_changes_nothing)
{
  for (const double coupling : {0., 0.1})
    {
      Options options;
      options.coupling       = coupling;
      ContactProblem problem = half_plane_problem(options);
      const Solution without = solve(problem);
      DenseMatrix    W       = problem.operators.W().dense();
      for (unsigned int j = 0; j < problem.n_nodes(); ++j)
        for (unsigned int i = 0; i < problem.n_nodes(); ++i)
          W(i, j) += 1e7;
      problem.operators.set_compliance(std::move(W));
      const Solution with = solve(problem);
      BOOST_TEST(with.report.converged);
      BOOST_TEST(!with.report.used_fallback);
      BOOST_TEST(std::abs(force(with) - force(without)) < 1e-7);
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
      ContactProblem problem  = half_plane_problem(options);
      problem.loads.free_slip = NodalField(problem.n_nodes(), 1);
      problem.loads.free_slip(0, problem.n_nodes() / 2) = std::nan("");
      const Solution solution = solve(problem, solver);
      BOOST_TEST(!solution.report.converged);
      BOOST_TEST(!solution.report.reason.empty());
    }
}

BOOST_AUTO_TEST_CASE(separate_patches_are_found)
{
  Options options;
  options.friction       = false;
  ContactProblem problem = half_plane_problem(options);
  for (unsigned int i = 0; i < problem.n_nodes(); ++i)
    problem.loads.gap[i] =
      0.02 * std::pow(std::sin(4 * problem.operators.positions()[i][0]), 2) +
      0.01 * std::pow(problem.operators.positions()[i][0], 2);
  problem.loads.normal_load = 0.02;
  const Solution solution   = solve(problem);
  BOOST_TEST(solution.report.converged);
  unsigned int n_edges = 0;
  for (unsigned int i = 0; i + 1 < problem.n_nodes(); ++i)
    n_edges += (solution.state.pressure[i] > 0.) !=
               (solution.state.pressure[i + 1] > 0.);
  BOOST_TEST(n_edges >= 4u);
}

BOOST_AUTO_TEST_CASE(no_contact_and_one_node)
{
  Options        options;
  ContactProblem problem = half_plane_problem(options);
  problem.loads.normal_load.reset();
  problem.loads.approach = -0.1;
  const Solution open    = solve(problem);
  BOOST_TEST(open.report.converged);
  BOOST_TEST(open.result.n_touching == 0u);
  BOOST_TEST(open.result.normal_force == 0.);
  problem.loads.approach = 1e-9 + *std::min_element(problem.loads.gap.begin(),
                                                    problem.loads.gap.end());
  const Solution one     = solve(problem);
  BOOST_TEST(one.report.converged);
  BOOST_TEST(one.result.n_touching == 1u);
  BOOST_TEST(one.result.normal_force > 0.);
}

BOOST_AUTO_TEST_SUITE_END()
