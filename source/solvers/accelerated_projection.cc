#include <rolling_contact/solvers/accelerated_projection.h>
#include <rolling_contact/solvers/anderson.h>

#include <cmath>

namespace RollingContact
{
  SolverReport
  AcceleratedProjection::solve(const TangentialProblem &problem,
                               ContactState            &state) const
  {
    const unsigned int depth = 10;
    const double       norm  = problem.contact.tangential_norm;
    SolverReport       report;
    report.solver = "accelerated projection";
    Anderson             anderson(depth);
    std::vector<double> &q = state.traction;
    problem.project(q);
    while (true)
      {
        const std::vector<double> slip = problem.slip(q);
        report.residual.tangential     = problem.residual(q, slip);
        report.history.push_back(report.residual);
        report.converged =
          report.residual.tangential <= 0.5 * controls.tolerance;
        if (report.converged || !std::isfinite(report.residual.tangential) ||
            report.iterations == controls.max_iterations)
          break;
        ++report.iterations;
        std::vector<double> projected(q);
        for (std::size_t i = 0; i < q.size(); ++i)
          projected[i] -= slip[i] / norm;
        problem.project(projected);
        q = anderson.next(q, projected);
        problem.project(q);
      }
    if (!report.converged)
      report.reason = "the accelerated projections reached their limit";
    return report;
  }
} // namespace RollingContact
