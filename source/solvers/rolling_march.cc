#include <rolling_contact/base/interrupt.h>
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
    double patch_length(const ContactProblem &problem,
                        const ContactState   &state)
    {
      double lower = std::numeric_limits<double>::max(), upper = -lower;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        if (state.pressure[i] > 0.)
          {
            lower = std::min(lower, problem.operators.positions()[i][0]);
            upper = std::max(upper, problem.operators.positions()[i][0]);
          }
      return upper > lower ? upper - lower
                           : problem.operators.positions().back()[0] -
                               problem.operators.positions().front()[0];
    }

    /**
     * The first step and the growth of the next ones, in lengths of the patch:
     * shorter steps are easier to solve and more. At the last step the rate is
     * 1e-4 of what convection does on the patch, and the steady problem is
     * tried a last time.
     */
    const double first_step = 0.01, growth = 1.4, last_step = 1e4;

    /**
     * The steady problem is tried after so many steps, and the march given up
     * after that many steps or halvings. Empirical: from the first step to the
     * last one is 41 steps without halving.
     */
    const unsigned int between_trials = 10, max_halvings = 8, max_steps = 80;
  } // namespace

  SolverReport RollingMarch::solve(const ContactProblem &problem,
                                   ContactState         &state) const
  {
    SolverReport report;
    report.solver = "rolling march";
    complete(problem, state);
    state.traction = NodalField(problem.n_nodes(), problem.n_tangential());
    const double   length       = patch_length(problem, state);
    double         h            = first_step * length;
    ContactProblem step         = problem;
    const auto     displacement = [&]() {
      return problem.operators.tangential_displacement(state.traction,
                                                       state.pressure);
    };
    NodalField   before     = displacement();
    unsigned int n_halvings = 0, n_done = 0;
    for (unsigned int k = 0; k < max_steps && n_halvings < max_halvings; ++k)
      {
        throw_if_interrupted();
        step.operators.set_time_scaling(
          {problem.operators.time_scaling().convection, 1 / h});
        step.loads.free_slip = before;
        for (double &value : step.loads.free_slip)
          value /= -h;
        ContactState       next = state;
        const SolverReport part = step_solver->solve(step, next);
        report.add_work(part);
        if (!part.converged)
          {
            h /= 2;
            ++n_halvings;
            continue;
          }
        state  = next;
        before = displacement();
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
