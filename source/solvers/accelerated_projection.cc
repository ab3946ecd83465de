#include <rolling_contact/solvers/accelerated_projection.h>
#include <rolling_contact/solvers/anderson.h>

namespace RollingContact
{
  SolverReport AcceleratedProjection::solve(const TangentialProblem &problem,
                                            ContactState &state) const
  {
    const unsigned int depth = 10;
    Anderson           anderson(depth);
    SolverReport       report;
    report.solver = "accelerated projection";
    NodalField &q = state.traction;
    problem.project(q);
    while (true)
      {
        const NodalField slip = problem.slip(q);
        if (ends_with(problem.residual(q, slip), report))
          return report;
        if (report.iterations == controls.max_iterations)
          break;
        ++report.iterations;
        NodalField projected = problem.trial(q, slip);
        problem.project(projected);
        q = anderson.next(q, projected);
        problem.project(q);
      }
    report.reason = "the accelerated projections reached their limit";
    return report;
  }
} // namespace RollingContact
