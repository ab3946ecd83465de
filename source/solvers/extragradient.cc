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
    std::vector<double>
    projected_step(const TangentialProblem   &problem,
                   const std::vector<double> &traction,
                   const std::vector<double> &slip,
                   const double               rho)
    {
      std::vector<double> result(traction);
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i] -= rho * slip[i];
      problem.project(result);
      return result;
    }



    double
    distance(const std::vector<double> &x, const std::vector<double> &y)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < x.size(); ++i)
        sum += (x[i] - y[i]) * (x[i] - y[i]);
      return std::sqrt(sum);
    }
  } // namespace



  SolverReport
  Extragradient::solve(const TangentialProblem &problem,
                       ContactState            &state) const
  {
    SolverReport report;
    report.solver             = "extragradient";
    std::vector<double> &q    = state.traction;
    const double         norm = problem.contact.tangential_norm;
    problem.project(q);
    if (norm == 0.)
      {
        report.converged = true;
        return report;
      }
    double rho = 1 / norm;
    while (report.iterations < controls.max_iterations)
      {
        const std::vector<double> s = problem.slip(q);
        report.residual.tangential  = problem.residual(q, s);
        report.history.push_back(report.residual);
        if (!std::isfinite(report.residual.tangential))
          {
            report.reason = "the traction is not a number";
            return report;
          }
        if (report.residual.tangential <= 0.5 * controls.tolerance)
          {
            report.converged = true;
            return report;
          }
        ++report.iterations;
        std::vector<double> predicted, predicted_slip;
        double              ratio = 0.;
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
