#include <rolling_contact/solvers/coupled_newton.h>
#include <rolling_contact/solvers/rolling_march.h>
#include <rolling_contact/solvers/solver_chain.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * One solver after the other on the same start.
     */
    class InTurn : public ContactSolver
    {
    public:
      explicit InTurn(std::vector<std::shared_ptr<const ContactSolver>> solvers)
        : solvers(std::move(solvers))
      {}

      SolverReport
      solve(const ContactProblem &problem, ContactState &state) const override
      {
        const ContactState start = state;
        SolverReport       report;
        for (const auto &solver : solvers)
          {
            state  = start;
            report = solver->solve(problem, state);
            if (report.converged)
              break;
          }
        return report;
      }

    private:
      std::vector<std::shared_ptr<const ContactSolver>> solvers;
    };
  } // namespace



  SolverChain::SolverChain(std::shared_ptr<const ContactSolver> alternation,
                           const SolverControls                &controls)
    : alternation(std::move(alternation))
    , newton(std::make_shared<CoupledNewton>(controls))
    , controls(controls)
  {}



  SolverReport
  SolverChain::solve(const ContactProblem &problem, ContactState &state) const
  {
    state.edge_law            = true;
    const ContactState start  = state;
    SolverReport       report = alternation->solve(problem, state);
    if (report.converged || problem.n_tangential == 0)
      return report;
    ContactState best  = state;
    SolverReport worst = report;
    const auto   attempt =
      [&](const ContactSolver &solver, ContactState from, const bool edge_law) {
        from.edge_law     = edge_law;
        SolverReport next = solver.solve(problem, from);
        report.iterations += next.iterations;
        report.normal_solves += next.normal_solves;
        report.tangential_solves += next.tangential_solves;
        report.passes += next.passes;
        report.history.insert(report.history.end(),
                              next.history.begin(),
                              next.history.end());
        if (!next.converged)
          return false;
        report.converged = true;
        report.residual  = next.residual;
        report.reason.clear();
        report.solver += ", fallback " + next.solver;
        if (!edge_law)
          report.solver += " without edge law";
        state = from;
        return true;
      };
    if (attempt(*newton, best, true))
      return report;
    const bool steady       = problem.rate == 0.;
    const bool has_edge_law = steady && problem.slip_operator.has_edge_law();
    if (has_edge_law &&
        (attempt(*alternation, start, false) || attempt(*newton, start, false)))
      return report;
    if (steady)
      {
        const RollingMarch march(
          std::make_shared<InTurn>(
            std::vector<std::shared_ptr<const ContactSolver>>{newton,
                                                              alternation}),
          controls);
        if (attempt(march, start, true) ||
            (has_edge_law && attempt(march, start, false)))
          return report;
      }
    return report;
  }
} // namespace RollingContact
