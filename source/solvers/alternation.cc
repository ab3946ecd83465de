#include <rolling_contact/contact/edge_law.h>
#include <rolling_contact/solvers/alternation.h>
#include <rolling_contact/solvers/anderson.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
            if (k > 0 && !report.used_fallback)
              report.solver += ", fallback " + friction.solver;
            report.used_fallback = report.used_fallback || k > 0;
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
    using Edges = std::vector<EdgeExtrapolation>;

    /**
     * @p part of the way from @p now to @p next.
     */
    Edges
    moved(const Edges &now, const Edges &next, const double part)
    {
      Edges result = next;
      for (EdgeExtrapolation &edge : result)
        if (const EdgeExtrapolation *old = find_edge(now, edge.first))
          {
            edge.second = old->second + part * (edge.second - old->second);
            edge.third  = old->third + part * (edge.third - old->third);
            for (unsigned int c = 0; c < 2; ++c)
              edge.rest[c] =
                old->rest[c] + part * (edge.rest[c] - old->rest[c]);
          }
      return result;
    }



    /**
     * Those of @p now that @p next has as well.
     */
    Edges
    common(const Edges &now, const Edges &next)
    {
      Edges result;
      for (const EdgeExtrapolation &edge : now)
        if (find_edge(next, edge.first))
          result.push_back(edge);
      return result;
    }
  } // namespace



  SolverReport
  Alternation::solve(const ContactProblem &problem, ContactState &state) const
  {
    // full steps first, then shorter ones: the rounds tend to alternate
    const unsigned int full_rounds = 2, max_rounds = 16;
    const double       settled = 1e-5, part = 0.7;
    SolverReport       report;
    report.solver = "active set";
    state.pressure.resize(problem.n_nodes, 0.);
    state.traction.resize(problem.n_tangential * problem.n_nodes, 0.);
    Edges asked = alternate(problem, state, report);
    if (!report.converged && !state.edges.empty())
      {
        // those of another state
        state.edges.clear();
        asked = alternate(problem, state, report);
      }
    for (unsigned int round = 0;
         report.converged && difference(asked, state.edges) > settled &&
         round < max_rounds;
         ++round)
      {
        const ContactState solved = state;
        state.edges               = round < full_rounds ? asked
                                    : round + 1 < max_rounds ? moved(state.edges, asked, part)
                                                             : common(state.edges, asked);
        asked                     = alternate(problem, state, report);
        if (report.converged)
          continue;
        // a node that barely touches may come and go with what is asked of the
        // next one: go back to a law that had a solution
        state = solved;
        alternate(problem, state, report);
        report.solver += ", edges of an earlier round";
        return report;
      }
    if (report.converged && difference(asked, state.edges) > settled)
      report.solver += ", edges unsettled";
    return report;
  }



  std::vector<EdgeExtrapolation>
  Alternation::alternate(const ContactProblem &problem,
                         ContactState         &state,
                         SolverReport         &report) const
  {
    const unsigned int plain_passes = 10, max_passes = 200, depth = 5,
                       patience = 40;
    double       lowest         = std::numeric_limits<double>::infinity();
    unsigned int n_stalled      = 0;
    Anderson     anderson(depth);
    report.converged = false;
    for (unsigned int pass = 1; pass <= max_passes && n_stalled < patience;
         ++pass)
      {
        ++report.passes;
        const SolverReport pressure = normal->solve(problem, state);
        report.iterations += pressure.iterations;
        report.normal_solves += pressure.normal_solves;
        const std::vector<double> start    = state.traction;
        const TangentialProblem   friction = tangential_problem(problem, state);
        const bool                solved =
          pressure.converged && (problem.n_tangential == 0 ||
                                 solve_with_any(friction, state, report));
        if (!pressure.converged)
          report.reason = pressure.reason;
        report.residual = natural_residual(problem, friction, state);
        report.history.push_back(report.residual);
        if (!std::isfinite(report.residual.worst()))
          report.reason = std::isfinite(report.residual.normal)
                            ? "the traction is not a number"
                            : "the pressure is not a number";
        if (!solved || !std::isfinite(report.residual.worst()))
          return {};
        if (report.residual.worst() <= controls.tolerance)
          {
            report.converged = true;
            report.reason.clear();
            return extrapolate_edges(friction, state.traction);
          }
        if (!problem.coupled)
          {
            report.reason = "rounding keeps the residual above the tolerance";
            return {};
          }
        n_stalled = report.residual.worst() < 0.5 * lowest ? 0 : n_stalled + 1;
        lowest    = std::min(lowest, report.residual.worst());
        if (pass >= plain_passes)
          state.traction = anderson.next(start, state.traction);
      }
    report.reason = "alternating normal and tangential solves did not settle";
    return {};
  }
} // namespace RollingContact
