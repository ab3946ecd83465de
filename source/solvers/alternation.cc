#include <rolling_contact/contact/edge_law.h>
#include <rolling_contact/solvers/alternation.h>
#include <rolling_contact/solvers/anderson.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  Alternation::Alternation(
    std::unique_ptr<NormalSolver>                  normal,
    std::vector<std::unique_ptr<TangentialSolver>> tangential,
    const SolverControls                          &controls)
    : normal(std::move(normal))
    , tangential(std::move(tangential))
    , controls(controls)
  {}



  bool
  Alternation::solve_with_any(const TangentialProblem &problem,
                              ContactState            &state,
                              SolverReport            &report) const
  {
    for (std::size_t k = 0; k < tangential.size(); ++k)
      {
        const std::vector<double> start = state.traction;
        const SolverReport friction     = tangential[k]->solve(problem, state);
        report.iterations += friction.iterations;
        report.tangential_solves += friction.tangential_solves;
        if (friction.converged)
          {
            if (k > 0 &&
                report.solver.find(friction.solver) == std::string::npos)
              report.solver += ", fallback " + friction.solver;
            return true;
          }
        report.reason = friction.reason;
        if (k + 1 < tangential.size())
          state.traction = start;
      }
    return false;
  }



  namespace
  {
    /**
     * The edges marked in both; empty if there is none.
     */
    std::vector<bool>
    common_edges(const std::vector<bool> &first,
                 const std::vector<bool> &second)
    {
      std::vector<bool> common(std::min(first.size(), second.size()));
      for (std::size_t i = 0; i < common.size(); ++i)
        common[i] = first[i] && second[i];
      return std::find(common.begin(), common.end(), true) == common.end()
               ? std::vector<bool>()
               : common;
    }
  } // namespace



  bool
  Alternation::solve_friction(const ContactProblem &problem,
                              ContactState         &state,
                              SolverReport         &report) const
  {
    const unsigned int max_rounds = 4;
    if (problem.n_tangential == 0)
      return true;
    if (!state.linear_edges.empty())
      {
        const TangentialProblem friction = tangential_problem(problem, state);
        if (solve_with_any(friction, state, report) &&
            sticking_edges(friction, state.traction) == state.linear_edges)
          return true;
      }
    state.linear_edges.clear();
    const TangentialProblem constant_law = tangential_problem(problem, state);
    if (!solve_with_any(constant_law, state, report))
      return false;
    state.linear_edges = sticking_edges(constant_law, state.traction, 1);
    for (unsigned int round = 0; round < max_rounds; ++round)
      {
        if (state.linear_edges.empty())
          return round == 0 ||
                 solve_with_any(tangential_problem(problem, state),
                                state,
                                report);
        const TangentialProblem linear_law = tangential_problem(problem, state);
        if (!solve_with_any(linear_law, state, report))
          return false;
        const auto sticking = sticking_edges(linear_law, state.traction);
        if (sticking == state.linear_edges)
          return true;
        state.linear_edges = common_edges(sticking, state.linear_edges);
      }
    return solve_with_any(tangential_problem(problem, state), state, report);
  }



  SolverReport
  Alternation::solve(const ContactProblem &problem, ContactState &state) const
  {
    const unsigned int plain_passes = 10, max_passes = 200, depth = 5;
    SolverReport       report;
    Anderson           anderson(depth);
    state.pressure.resize(problem.n_nodes, 0.);
    state.traction.resize(problem.n_tangential * problem.n_nodes, 0.);
    report.solver = "active set";
    while (report.passes < max_passes)
      {
        ++report.passes;
        const SolverReport pressure = normal->solve(problem, state);
        report.iterations += pressure.iterations;
        report.normal_solves += pressure.normal_solves;
        const std::vector<double> start = state.traction;
        const bool                solved =
          pressure.converged && solve_friction(problem, state, report);
        if (!pressure.converged)
          report.reason = pressure.reason;
        report.residual =
          natural_residual(problem, tangential_problem(problem, state), state);
        report.history.push_back(report.residual);
        if (!std::isfinite(report.residual.worst()))
          report.reason = std::isfinite(report.residual.normal)
                            ? "the traction is not a number"
                            : "the pressure is not a number";
        if (!solved || !std::isfinite(report.residual.worst()))
          return report;
        if (report.residual.worst() <= controls.tolerance)
          {
            report.converged = true;
            report.reason.clear();
            return report;
          }
        if (!problem.coupled)
          {
            report.reason = "rounding keeps the residual above the tolerance";
            return report;
          }
        if (report.passes >= plain_passes)
          state.traction = anderson.next(start, state.traction);
      }
    report.reason = "alternating normal and tangential solves did not settle";
    return report;
  }
} // namespace RollingContact
