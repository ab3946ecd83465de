#ifndef rolling_contact_tests_response_check_h
#define rolling_contact_tests_response_check_h

#include <rolling_contact/contact/sliding_response.h>
#include <rolling_contact/solvers/contact_solver.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  /**
   * sliding_response() against solves with a little less friction at every
   * third slipping node: the largest difference in the sliding of the slipping
   * nodes over the largest change.
   */
  inline double error_of_response(const ContactProblem &problem,
                                  const ContactState   &state)
  {
    const auto sizes = [&](const ContactProblem &of, const ContactState &at) {
      const auto          s = tangential_problem(of, at).slip(at.traction);
      std::vector<double> result;
      for (std::size_t i = 0; i < s.n_nodes(); ++i)
        result.push_back(s.norm_at(i));
      return result;
    };
    const TangentialProblem tangential = tangential_problem(problem, state);
    const auto              nodes = slipping_nodes(tangential, state.traction);
    const DenseMatrix R = sliding_response(tangential, state.traction, nodes);
    const auto        before = sizes(problem, state);
    const double      part   = 1e-6;
    double            error = 0., largest = 0.;
    for (std::size_t l = 0; l < nodes.size(); l += 3)
      {
        ContactProblem less = problem;
        less.loads.friction[nodes[l]] *= 1 - part;
        ContactState   next = state;
        SolverControls controls;
        controls.tolerance = 1e-13;
        make_contact_solver("automatic", controls)->solve(less, next);
        const auto   after = sizes(less, next);
        const double lost  = part * tangential.bound[nodes[l]];
        for (std::size_t k = 0; k < nodes.size(); ++k)
          {
            const double change = (after[nodes[k]] - before[nodes[k]]) / lost;
            error               = std::max(error, std::abs(change - R(k, l)));
            largest             = std::max(largest, std::abs(change));
          }
      }
    return largest > 0. ? error / largest : 1.;
  }
} // namespace RollingContact

#endif
