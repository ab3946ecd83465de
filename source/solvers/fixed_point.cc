#include <rolling_contact/solvers/fixed_point.h>

#include <algorithm>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    /**
     * The approach for which sum areas max(0, p - rho (u + gap - approach)) is
     * the load: the sum is piecewise linear and increasing in the approach.
     */
    double
    approach_for_load(const ContactProblem      &problem,
                      const std::vector<double> &trial,
                      const double               rho)
    {
      std::vector<unsigned int> order(trial.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const auto i, const auto j) {
        return trial[i] > trial[j];
      });
      double area = 0., force = 0., level = 0.;
      for (const unsigned int i : order)
        {
          if (area > 0. && trial[i] <= level)
            break;
          area += problem.operators.areas()[i];
          force += problem.operators.areas()[i] * trial[i];
          level = (force - *problem.loads.normal_load) / area;
        }
      return -level / rho;
    }



    void
    project_pressure(const ContactProblem &problem,
                     const double          rho,
                     ContactState         &state)
    {
      std::vector<double> trial = normal_gap(problem, state);
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        trial[i] = state.pressure[i] - rho * (trial[i] + state.approach);
      state.approach = problem.loads.normal_load
                         ? approach_for_load(problem, trial, rho)
                         : problem.loads.approach;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        state.pressure[i] = std::max(0., trial[i] + rho * state.approach);
    }
  } // namespace



  SolverReport
  FixedPoint::solve(const ContactProblem &problem, ContactState &state) const
  {
    SolverReport report;
    report.solver = "fixed point";
    complete(problem, state);
    const double norm  = problem.operators.tangential_norm(),
                 rho_n = controls.normal_augmentation /
                         problem.operators.normal_norm(),
                 rho_t =
                   norm > 0. ? controls.tangential_augmentation / norm : 0.;
    while (report.iterations < controls.max_iterations)
      {
        ++report.iterations;
        project_pressure(problem, rho_n, state);
        const TangentialProblem friction = tangential_problem(problem, state);
        if (problem.n_tangential() > 0)
          {
            state.traction.add(-rho_t, friction.slip(state.traction));
            friction.project(state.traction);
          }
        if (report.ends_with(natural_residual(problem, friction, state),
                             controls.tolerance))
          return report;
      }
    report.reason = "the fixed point reached its limit of " +
                    std::to_string(controls.max_iterations) + " iterations";
    return report;
  }
} // namespace RollingContact
