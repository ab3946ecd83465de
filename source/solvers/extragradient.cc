#include <rolling_contact/solvers/extragradient.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Proj(q - rho s).
     */
    NodalField projected_step(const TangentialProblem &problem,
                              NodalField               traction,
                              const NodalField        &slip,
                              const double             rho)
    {
      traction.add(-rho, slip);
      problem.project(traction);
      return traction;
    }

    double distance(NodalField x, const NodalField &y)
    {
      x -= y;
      return std::sqrt(dot(x, x));
    }
  } // namespace

  SolverReport Extragradient::solve(const TangentialProblem &problem,
                                    ContactState            &state) const
  {
    SolverReport report;
    report.solver     = "extragradient";
    NodalField  &q    = state.traction;
    const double norm = problem.contact.operators.tangential_norm();
    problem.project(q);
    if (norm == 0.)
      {
        report.converged = true;
        return report;
      }
    double rho = 1 / norm;
    while (report.iterations < controls.max_iterations)
      {
        const NodalField s = problem.slip(q);
        if (ends_with(problem.residual(q, s), report))
          return report;
        ++report.iterations;
        NodalField predicted, predicted_slip;
        double     ratio = 0.;
        for (unsigned int shrinkings = 0; shrinkings < 60; ++shrinkings)
          {
            predicted         = projected_step(problem, q, s, rho);
            predicted_slip    = problem.slip(predicted);
            const double step = distance(predicted, q);
            ratio = step > 0. ? rho * distance(predicted_slip, s) / step : 0.;
            if (ratio <= 0.9)
              break;
            rho *= 0.8 * std::min(1., 0.9 / ratio);
          }
        q = projected_step(problem, q, predicted_slip, rho);
        if (ratio < 0.4)
          rho *= 1.4;
      }
    report.reason = "the extragradient iteration reached its limit";
    return report;
  }
} // namespace RollingContact
