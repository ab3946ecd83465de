#include <rolling_contact/solvers/fixed_point.h>

#include <algorithm>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    /**
     * The approach for which the load of max(0, p - rho (u + gap - share
     * approach)) is the given one: it is piecewise linear and increasing in the
     * approach.
     */
    double approach_for_load(const ContactProblem      &problem,
                             const std::vector<double> &trial,
                             const double               rho)
    {
      const ContactOperators &operators = problem.operators;
      // where a node leaves contact
      const auto limit = [&](const unsigned int i) {
        return trial[i] / operators.approach_share(i);
      };
      std::vector<unsigned int> order(trial.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const auto i, const auto j) {
        return limit(i) > limit(j);
      });
      double area = 0., force = 0., level = 0.;
      for (const unsigned int i : order)
        {
          if (area > 0. && limit(i) <= level)
            break;
          area += operators.load_areas()[i] * operators.approach_share(i);
          force += operators.load_areas()[i] * trial[i];
          level = (force - *problem.loads.normal_load) / area;
        }
      return -level / rho;
    }

    void project_pressure(const ContactProblem &problem,
                          const double          rho,
                          ContactState         &state)
    {
      const auto share = [&](const unsigned int i) {
        return problem.operators.approach_share(i);
      };
      std::vector<double> trial = normal_gap(problem, state);
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        trial[i] =
          state.pressure[i] - rho * (trial[i] + share(i) * state.approach);
      state.approach = problem.loads.normal_load
                         ? approach_for_load(problem, trial, rho)
                         : problem.loads.approach;
      for (unsigned int i = 0; i < problem.n_nodes(); ++i)
        state.pressure[i] =
          std::max(0., trial[i] + rho * share(i) * state.approach);
    }
  } // namespace

  SolverReport FixedPoint::solve(const ContactProblem &problem,
                                 ContactState         &state) const
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
