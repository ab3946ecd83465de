#include <rolling_contact/solvers/extragradient.h>
#include <rolling_contact/solvers/semismooth_newton.h>

#include <array>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * The touching unknowns, both components of a node side by side.
     */
    std::vector<std::size_t>
    touching_unknowns(const TangentialProblem &problem)
    {
      std::vector<std::size_t> unknowns;
      for (unsigned int i = 0; i < problem.contact.n_nodes; ++i)
        if (problem.bound[i] > 0.)
          for (unsigned int c = 0; c < 2; ++c)
            unknowns.push_back(c * problem.contact.n_nodes + i);
      return unknowns;
    }



    /**
     * D = mu p/|z| (1 - z z^T/|z|^2), the derivative of the projection.
     */
    std::array<std::array<double, 2>, 2>
    projection_derivative(const double bound, const std::array<double, 2> &z)
    {
      const double size = std::hypot(z[0], z[1]), scale = bound / size;
      const double x = z[0] / size, y = z[1] / size;
      return {{{{scale * (1 - x * x), -scale * x * y}},
               {{-scale * x * y, scale * (1 - y * y)}}}};
    }



    /**
     * Newton matrix and right-hand side for the step of the traction.
     */
    void
    linearise(const TangentialProblem        &problem,
              const DenseMatrix              &slip_compliance,
              const std::vector<std::size_t> &unknowns,
              const std::vector<double>      &traction,
              const double                    rho,
              DenseMatrix                    &matrix,
              DenseMatrix                    &step)
    {
      const std::vector<double> slip = problem.slip(traction);
      const std::size_t         n    = unknowns.size();
      for (std::size_t k = 0; k < n; k += 2)
        {
          const std::size_t     i = unknowns[k], j = unknowns[k + 1];
          const double          bound = problem.bound[i];
          std::array<double, 2> z{
            {traction[i] - rho * slip[i], traction[j] - rho * slip[j]}};
          if (std::hypot(z[0], z[1]) <= bound)
            {
              for (std::size_t column = 0; column < n; ++column)
                {
                  matrix(k, column) =
                    rho * slip_compliance(i, unknowns[column]);
                  matrix(k + 1, column) =
                    rho * slip_compliance(j, unknowns[column]);
                }
              step(k, 0)     = -rho * slip[i];
              step(k + 1, 0) = -rho * slip[j];
              continue;
            }
          const auto D = projection_derivative(bound, z);
          for (std::size_t column = 0; column < n; ++column)
            {
              const double x = rho * slip_compliance(i, unknowns[column]) -
                               (column == k ? 1. : 0.),
                           y = rho * slip_compliance(j, unknowns[column]) -
                               (column == k + 1 ? 1. : 0.);
              matrix(k, column) =
                D[0][0] * x + D[0][1] * y + (column == k ? 1. : 0.);
              matrix(k + 1, column) =
                D[1][0] * x + D[1][1] * y + (column == k + 1 ? 1. : 0.);
            }
          const double size = std::hypot(z[0], z[1]);
          step(k, 0)        = bound * z[0] / size - traction[i];
          step(k + 1, 0)    = bound * z[1] / size - traction[j];
        }
    }



    double
    residual(const TangentialProblem   &problem,
             const std::vector<double> &traction,
             const double               friction_force)
    {
      std::vector<double> projected = traction;
      const auto          slip      = problem.slip(traction);
      for (std::size_t i = 0; i < projected.size(); ++i)
        projected[i] -= slip[i] / problem.contact.tangential_norm;
      problem.project(projected);
      double sum = 0.;
      for (std::size_t i = 0; i < projected.size(); ++i)
        sum += problem.contact.areas[i % problem.contact.n_nodes] *
               std::abs(traction[i] - projected[i]);
      return sum / friction_force;
    }


    /**
     * Add the part 1, 1/2, ..., 1/64 of a step to the traction: the first that
     * lowers the residual by a tenth of the part, else the best of them.
     */
    void
    take_damped_step(const TangentialProblem        &problem,
                     const std::vector<std::size_t> &unknowns,
                     const DenseMatrix              &step,
                     const double                    residual_now,
                     const double                    friction_force,
                     std::vector<double>            &traction)
    {
      const std::vector<double> start = traction;
      std::vector<double>       best_traction;
      double                    best = std::numeric_limits<double>::infinity();
      for (double part = 1.; part > 0.01; part /= 2)
        {
          for (std::size_t k = 0; k < unknowns.size(); ++k)
            traction[unknowns[k]] = start[unknowns[k]] + part * step(k, 0);
          const double now = residual(problem, traction, friction_force);
          if (now < (1 - 0.1 * part) * residual_now)
            return;
          if (best_traction.empty() || now < best)
            {
              best          = now;
              best_traction = traction;
            }
        }
      traction = best_traction;
    }
  } // namespace



  SolverReport
  SemismoothNewton::solve(const TangentialProblem &problem,
                          ContactState            &state) const
  {
    const unsigned int max_steps = 60, patience = 6, max_rescues = 4;
    SolverReport       report;
    report.solver                           = "active set";
    const std::vector<std::size_t> unknowns = touching_unknowns(problem);
    const double                   norm     = problem.contact.tangential_norm;
    const double friction_force = problem.contact.resultant(problem.bound);
    problem.project(state.traction);
    if (unknowns.empty() || norm == 0.)
      {
        report.converged = true;
        return report;
      }
    const double        rho = controls.tangential_augmentation / norm;
    const DenseMatrix   slip_compliance = problem.slip_compliance();
    double              best            = 0.;
    unsigned int        n_stalled = 0, n_rescues = 0;
    std::vector<double> best_traction;
    for (unsigned int k = 0; k <= max_steps; ++k)
      {
        const double now = residual(problem, state.traction, friction_force);
        report.residual.tangential = now;
        report.history.push_back(report.residual);
        if (now <= 0.5 * controls.tolerance)
          {
            report.converged = true;
            return report;
          }
        n_stalled = k > 0 && !(now < best) ? n_stalled + 1 : 0;
        if (n_stalled == 0)
          {
            best          = now;
            best_traction = state.traction;
          }
        if (n_rescues > max_rescues || (k == 0 && !std::isfinite(now)))
          break;
        if (n_stalled > patience || !std::isfinite(now))
          {
            SolverControls rescue = controls;
            rescue.max_iterations = 20u << n_rescues++;
            state.traction        = best_traction;
            report.iterations +=
              Extragradient(rescue).solve(problem, state).iterations;
            n_stalled = 0;
            best      = std::numeric_limits<double>::infinity();
            continue;
          }
        DenseMatrix matrix(unknowns.size(), unknowns.size()),
          step(unknowns.size(), 1);
        linearise(problem,
                  slip_compliance,
                  unknowns,
                  state.traction,
                  rho,
                  matrix,
                  step);
        if (!solve_general(matrix, step))
          break;
        take_damped_step(
          problem, unknowns, step, now, friction_force, state.traction);
        ++report.iterations;
        ++report.tangential_solves;
      }
    report.reason = "the semismooth Newton iteration stopped falling";
    return report;
  }
} // namespace RollingContact
