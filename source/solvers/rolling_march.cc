#include <rolling_contact/parallel/interrupt.h>
#include <rolling_contact/solvers/rolling_march.h>

#include <algorithm>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * Length along x of the nodes that touch, at least that of one element.
     */
    double
    patch_length(const ContactProblem &problem, const ContactState &state)
    {
      double lower = std::numeric_limits<double>::max(), upper = -lower;
      for (unsigned int i = 0; i < problem.n_nodes; ++i)
        if (state.pressure[i] > 0.)
          {
            lower = std::min(lower, problem.positions[i][0]);
            upper = std::max(upper, problem.positions[i][0]);
          }
      return upper > lower
               ? upper - lower
               : problem.positions.back()[0] - problem.positions.front()[0];
    }
  } // namespace



  SolverReport
  RollingMarch::solve(const ContactProblem &problem, ContactState &state) const
  {
    const unsigned int max_steps = 80, max_halvings = 8, between_trials = 10;
    const double       first_step = 0.01, growth = 1.4, last_step = 1e4;
    SolverReport       report;
    report.solver = "rolling march";
    state.pressure.resize(problem.n_nodes, 0.);
    state.traction.assign(problem.n_tangential * problem.n_nodes, 0.);
    const double   length = patch_length(problem, state);
    double         h      = first_step * length;
    ContactProblem step   = problem;
    auto           before =
      problem.tangential_displacement(state.traction, state.pressure);
    unsigned int n_halvings = 0, n_done = 0;
    for (unsigned int k = 0; k < max_steps && n_halvings < max_halvings; ++k)
      {
        throw_if_interrupted();
        step.rate      = 1 / h;
        step.free_slip = before;
        for (double &value : step.free_slip)
          value /= -h;
        step.find_tangential_norm();
        ContactState       next = state;
        const SolverReport part = step_solver->solve(step, next);
        report.add_work(part);
        if (!part.converged)
          {
            h /= 2;
            ++n_halvings;
            continue;
          }
        state = next;
        before =
          problem.tangential_displacement(state.traction, state.pressure);
        h *= growth;
        if (++n_done % between_trials != 0 && h < last_step * length)
          continue;
        ContactState       steady = state;
        const SolverReport end    = step_solver->solve(problem, steady);
        report.add_work(end);
        if (end.converged)
          {
            state            = steady;
            report.converged = true;
            report.residual  = end.residual;
            return report;
          }
        if (h >= last_step * length)
          break;
      }
    report.residual =
      natural_residual(problem, tangential_problem(problem, state), state);
    report.reason = "the march in rolled distance found no steady state";
    return report;
  }
} // namespace RollingContact
