#include <boost/test/unit_test.hpp>

#include "half_plane.h"

#include <rolling_contact/contact/invariants.h>
#include <rolling_contact/solvers/coupled_newton.h>
#include <rolling_contact/solvers/rolling_march.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace RollingContact;
using namespace HalfPlane;

BOOST_AUTO_TEST_SUITE(fallbacks)

namespace
{
  const double tolerance = 1e-10;

  Solution solve_with(const ContactSolver  &solver,
                      const ContactProblem &problem)
  {
    Solution solution;
    solution.state = open_state(problem);
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (std::abs(problem.operators.positions()[i][0]) < 1.)
        solution.state.pressure[i] = 1.;
    solution.report = solver.solve(problem, solution.state);
    solution.result = resultants(problem, solution.state);
    return solution;
  }

  double distance(const Solution &first, const Solution &second)
  {
    double     largest = 0.;
    NodalField change  = first.state.traction;
    change -= second.state.traction;
    for (const double value : change)
      largest = std::max(largest, std::abs(value));
    return largest;
  }

  CoupledNewton newton()
  {
    return CoupledNewton(SolverControls());
  }

  RollingMarch march()
  {
    return RollingMarch(std::make_shared<CoupledNewton>(SolverControls()),
                        SolverControls());
  }

  Options coupled(const double beta)
  {
    Options options;
    options.kind     = SlipOperatorKind::upwind_2;
    options.coupling = beta;
    return options;
  }
} // namespace

BOOST_AUTO_TEST_CASE(newton_for_both_finds_what_solves_in_turn_find)
{
  for (const double beta : {0., 0.2})
    for (const double creepage : {0., 0.4, 2.})
      {
        Options options              = coupled(beta);
        options.creepage             = creepage;
        const ContactProblem problem = half_plane_problem(options);
        const Solution       both    = solve_with(newton(), problem);
        BOOST_TEST(both.report.converged);
        BOOST_TEST(distance(both, solve(problem)) < 1e-8);
      }
}

BOOST_AUTO_TEST_CASE(the_march_ends_at_carter_and_at_the_steady_state)
{
  for (const double beta : {0., 0.2})
    {
      const ContactProblem problem = half_plane_problem(coupled(beta));
      const Solution       marched = solve_with(march(), problem);
      BOOST_TEST(marched.report.converged);
      BOOST_TEST(distance(marched, solve(problem)) < 1e-8);
      if (beta == 0.)
        BOOST_TEST(std::abs(force(marched) - carter_force(0.4)) < 1e-2);
    }
}

BOOST_AUTO_TEST_CASE(strong_coupling_ends_converged_and_unbroken)
{
  // mu times Dundurs' constant up to 4.5
  for (const double friction : {1., 3., 9.})
    for (const double creepage : {-2., -0.1, 0., 0.1, 2.})
      {
        Options options        = coupled(0.5);
        options.n_elements     = 24;
        options.kind           = SlipOperatorKind::calibrated;
        ContactProblem problem = half_plane_problem(options);
        problem.loads.friction.assign(problem.n_nodes(), friction);
        problem.loads.creepages = {creepage * friction, 0., 0.};
        const Solution found    = solve(problem);
        BOOST_TEST_CONTEXT(friction << " " << creepage << " "
                                    << found.report.solver)
        {
          BOOST_TEST(found.report.converged);
          BOOST_TEST(invariants(problem, found.state).worst().second <=
                     invariant_limit(tolerance));
        }
      }
}

BOOST_AUTO_TEST_CASE(the_report_names_the_fallback)
{
  Options options        = coupled(0.5);
  options.n_elements     = 24;
  ContactProblem problem = half_plane_problem(options);
  problem.loads.friction.assign(problem.n_nodes(), 9.);
  problem.loads.creepages = {18., 0., 0.};
  const Solution found    = solve(problem);
  BOOST_TEST(found.report.converged);
  BOOST_TEST(found.report.used_fallback);
  BOOST_TEST(!solve(problem, "active set").report.converged);
}

BOOST_AUTO_TEST_SUITE_END()
