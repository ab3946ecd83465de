#include <rolling_contact/solvers/anderson.h>
#include <rolling_contact/solvers/normal_tangential_split.h>
#include <rolling_contact/solvers/scheme_rounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  NormalTangentialSplit::NormalTangentialSplit(
    std::unique_ptr<NormalSolver>                  normal,
    std::vector<std::unique_ptr<TangentialSolver>> tangential,
    const SolverControls                          &controls,
    const bool                                     economical)
    : normal(std::move(normal))
    , tangential(std::move(tangential))
    , controls(controls)
    , economical(economical)
  {}

  bool NormalTangentialSplit::solve_with_any(const TangentialProblem &problem,
                                             const std::size_t        n_solvers,
                                             ContactState            &state,
                                             SolverReport &report) const
  {
    for (std::size_t k = 0; k < n_solvers; ++k)
      {
        const NodalField   start    = state.traction;
        const SolverReport friction = tangential[k]->solve(problem, state);
        report.iterations += friction.iterations;
        report.tangential_solves += friction.tangential_solves;
        if (friction.converged)
          {
            if (k > 0 && !report.used_fallback)
              report.solver += ", fallback " + friction.solver;
            report.used_fallback = report.used_fallback || k > 0;
            report.reason.clear();
            return true;
          }
        report.reason = friction.reason;
        if (k + 1 < n_solvers)
          state.traction = start;
      }
    return false;
  }

  namespace
  {
    /**
     * Change of the coefficients of the extrapolations at which they are
     * settled: changes the force by less than discretisation by far.
     */
    const double settled = 1e-6;

    /**
     * Residual to which an economical round of the edge law solves whose
     * extrapolations change: so much of their change, and at most.
     */
    const double of_change = 1e-3, loosest = 1e-4;

    /**
     * Passes of a normal and a tangential solve: so many without acceleration,
     * which weak coupling does not need, then with the last @p depth changes;
     * given up after @p patience passes that have not halved the residual.
     * Empirical, larger numbers only cost time where there is no solution.
     */
    const unsigned int plain_passes = 10, depth = 5, patience = 40,
                       max_passes = 200;
  } // namespace

  SolverReport NormalTangentialSplit::solve(const ContactProblem &problem,
                                            ContactState         &state) const
  {
    SolverReport report;
    report.solver = "active set";
    complete(problem, state);
    // a scheme that the first solver fails with is worth no other solver: it
    // may leave no solution
    const auto n_solvers = [&] {
      return state.scheme.empty() ? tangential.size() : 1;
    };
    const double exact   = controls.tolerance;
    const bool   holds   = state.holds_scheme && !state.scheme.empty();
    double     tolerance = holds ? exact : tolerance_of_round(problem, loosest);
    SlipScheme asked =
      alternate(problem, n_solvers(), tolerance, state, report);
    if (holds)
      {
        report.solver += ", edges of a state nearby";
        report.edges_settled = false;
        return report;
      }
    if (!report.converged && !state.scheme.empty())
      {
        // those of another state
        state.scheme = {};
        asked = alternate(problem, n_solvers(), tolerance, state, report);
      }
    SchemeRounds rounds(economical ? SchemeRounds::economical
                                   : SchemeRounds::cautious);
    while (report.converged && rounds.round() < SchemeRounds::max_rounds)
      {
        asked               = rounds.admitted(state.scheme, asked);
        const double change = difference(asked, state.scheme);
        if (change <= settled && report.residual.worst() <= exact)
          return report;
        if (change <= settled)
          {
            asked = alternate(problem, n_solvers(), exact, state, report);
            continue;
          }
        tolerance                       = tolerance_of_round(problem, change);
        const ContactState solved       = state;
        const SlipScheme   asked_before = asked;
        state.scheme                    = rounds.next(state.scheme, asked);
        asked = alternate(problem, n_solvers(), tolerance, state, report);
        if (report.converged)
          continue;
        // a node that barely touches may come and go with what is asked of the
        // next one: go back to a law that had a solution
        const SlipScheme failed = state.scheme;
        state                   = solved;
        alternate(problem, tangential.size(), exact, state, report);
        if (rounds.exclude_new_edges(solved.scheme, failed))
          {
            asked = asked_before;
            continue;
          }
        report.solver += ", edges of an earlier round";
        report.edges_settled = false;
        return report;
      }
    if (report.converged && report.residual.worst() > exact)
      alternate(problem, tangential.size(), exact, state, report);
    if (report.converged)
      {
        report.solver += ", edges unsettled";
        report.edges_settled = false;
      }
    return report;
  }

  double
  NormalTangentialSplit::tolerance_of_round(const ContactProblem &problem,
                                            const double          change) const
  {
    return economical && problem.operators.slip_operator().has_edge_law()
             ? std::max(controls.tolerance,
                        std::min(loosest, of_change * change))
             : controls.tolerance;
  }

  SlipScheme NormalTangentialSplit::alternate(const ContactProblem &problem,
                                              const std::size_t     n_solvers,
                                              const double          tolerance,
                                              ContactState         &state,
                                              SolverReport &report) const
  {
    double       lowest    = std::numeric_limits<double>::infinity();
    unsigned int n_stalled = 0;
    Anderson     anderson(depth);
    report.converged = false;
    report.reason.clear();
    for (unsigned int pass = 1; pass <= max_passes && n_stalled < patience;
         ++pass)
      {
        ++report.passes;
        const SolverReport pressure = normal->solve(problem, state);
        report.iterations += pressure.iterations;
        report.normal_solves += pressure.normal_solves;
        const NodalField        start    = state.traction;
        const TangentialProblem friction = tangential_problem(problem, state);
        const bool              solved =
          pressure.converged &&
          (problem.n_tangential() == 0 ||
           solve_with_any(friction, n_solvers, state, report));
        if (!pressure.converged)
          report.reason = pressure.reason;
        const bool ended =
          report.ends_with(natural_residual(problem, friction, state),
                           tolerance);
        report.converged = report.converged && solved;
        if (report.converged)
          return slip_scheme(friction, state.traction);
        if (ended || !solved)
          return {};
        if (!problem.operators.coupling().exists)
          {
            report.reason = "rounding keeps the residual above the tolerance";
            return {};
          }
        const double residual = report.residual.worst();
        n_stalled             = residual < 0.5 * lowest ? 0 : n_stalled + 1;
        lowest                = std::min(lowest, residual);
        if (pass >= plain_passes)
          state.traction = anderson.next(start, state.traction);
      }
    report.reason = "alternating normal and tangential solves did not settle";
    return {};
  }
} // namespace RollingContact
