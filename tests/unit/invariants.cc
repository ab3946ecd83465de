#include <boost/test/unit_test.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/invariants.h>
#include <rolling_contact/solvers/contact_solver.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace RollingContact;

BOOST_AUTO_TEST_SUITE(state_invariants)

namespace
{
  const unsigned int n_nodes = 20;
  const double       load = 3., tolerance = 1e-10;

  /**
   * Two brush beds pressed together: every node has its own spring, normal and
   * tangential springs coupled.
   */
  ContactProblem brush_bed()
  {
    Trace trace;
    for (unsigned int i = 0; i < n_nodes; ++i)
      trace.nodes.push_back({{i - 9.3, 0.}});
    for (unsigned int i = 0; i + 1 < n_nodes; ++i)
      trace.cells.push_back({trace.nodes[i],
                             {{trace.nodes[i + 1][0], 1.}},
                             {{{i, 1.}}, {{i + 1, 1.}}}});
    DenseMatrix    W = DenseMatrix::Zero(2 * n_nodes, 2 * n_nodes);
    ContactProblem problem;
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        W(i, i) = W(n_nodes + i, n_nodes + i) = 1.;
        W(i, n_nodes + i) = W(n_nodes + i, i) = 0.05;
        problem.loads.gap.push_back(std::pow(trace.nodes[i][0], 2) / 50);
      }
    problem.operators =
      ContactOperators(trace.nodes,
                       contact_matrix(trace, ContactMatrices::lumped, 1.),
                       std::move(W),
                       SlipOperator(trace,
                                    SlipOperatorKind::upwind_2,
                                    ContactMatrices::lumped,
                                    1));
    problem.loads.friction.assign(n_nodes, 0.3);
    problem.loads.creepages   = {0.03, 0., 0.};
    problem.loads.normal_load = load;
    return problem;
  }

  ContactState solution(const ContactProblem &problem)
  {
    SolverControls controls;
    controls.tolerance = tolerance;
    ContactState       state;
    const SolverReport report =
      make_contact_solver("automatic", controls)->solve(problem, state);
    BOOST_REQUIRE(report.converged);
    return state;
  }

  using Value = double Invariants::*;

  /**
   * A change of the solution that breaks one invariant by at least this much.
   */
  void check_broken(
    const std::string                                           &name,
    const Value                                                  value,
    const std::function<void(ContactProblem &, ContactState &)> &spoil)
  {
    ContactProblem problem = brush_bed();
    ContactState   state   = solution(problem);
    spoil(problem, state);
    const Invariants found = invariants(problem, state);
    BOOST_TEST_CONTEXT(name)
    {
      BOOST_TEST(!(found.*value <= 1e-4));
      BOOST_CHECK_THROW(check_invariants(found, tolerance, ""),
                        ConvergenceError);
    }
  }

  unsigned int middle(const ContactState &state)
  {
    return std::max_element(state.pressure.begin(), state.pressure.end()) -
           state.pressure.begin();
  }
} // namespace

BOOST_AUTO_TEST_CASE(a_solution_breaks_none)
{
  const ContactProblem problem = brush_bed();
  const Invariants     found   = invariants(problem, solution(problem));
  BOOST_TEST(found.worst().second <= tolerance);
  BOOST_CHECK_NO_THROW(check_invariants(found, tolerance, ""));
  BOOST_TEST(found.named().size() == 7u);
}

BOOST_AUTO_TEST_CASE(each_is_seen_when_broken)
{
  check_broken("pull", &Invariants::pull, [](auto &, auto &state) {
    state.pressure[0] = -0.01;
  });
  check_broken("overlap", &Invariants::overlap, [](auto &problem, auto &state) {
    problem.loads.gap[middle(state)] -= 0.01;
  });
  check_broken("complementarity",
               &Invariants::complementarity,
               [](auto &problem, auto &state) {
                 problem.loads.gap[middle(state)] += 0.01;
               });
  check_broken("cone", &Invariants::cone, [](auto &, auto &state) {
    state.traction(0, middle(state)) = -0.301 * state.pressure[middle(state)];
  });
  check_broken("friction power",
               &Invariants::friction_power,
               [](auto &, auto &state) {
                 for (double &q : state.traction)
                   q = -q;
               });
  check_broken("load", &Invariants::load, [](auto &problem, auto &) {
    problem.loads.normal_load = 1.001 * load;
  });
  check_broken("elastic energy",
               &Invariants::elastic_energy,
               [](auto &problem, auto &) {
                 DenseMatrix W = problem.operators.W().dense();
                 for (unsigned int i = 0; i < 2 * n_nodes; ++i)
                   W(i, i) = -W(i, i);
                 problem.operators.set_compliance(std::move(W));
               });
}

BOOST_AUTO_TEST_CASE(what_is_not_a_number_is_broken)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool pressure : {true, false})
    {
      const ContactProblem problem = brush_bed();
      ContactState         state   = solution(problem);
      *(pressure ? state.pressure.begin() : state.traction.begin()) = nan;
      const Invariants found = invariants(problem, state);
      BOOST_TEST(!std::isfinite(found.worst().second));
      BOOST_CHECK_THROW(check_invariants(found, tolerance, ""),
                        ConvergenceError);
    }
}

BOOST_AUTO_TEST_CASE(the_message_names_invariant_value_and_limit)
{
  Invariants found;
  found.cone = 2.5e-7;
  BOOST_CHECK_EXCEPTION(check_invariants(found, tolerance, "Level 3: "),
                        ConvergenceError,
                        [](const ConvergenceError &error) {
                          const std::string text = error.what();
                          return text.find("Level 3: ") == 0 &&
                                 text.find("`cone`") != std::string::npos &&
                                 text.find("2.50e-07") != std::string::npos &&
                                 text.find("1.01e-10") != std::string::npos;
                        });
}

BOOST_AUTO_TEST_SUITE_END()
