#include <rolling_contact/solvers/coupled_newton.h>
#include <rolling_contact/solvers/rolling_march.h>
#include <rolling_contact/solvers/solver_chain.h>

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

      SolverReport solve(const ContactProblem &problem,
                         ContactState         &state) const override
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

  SolverChain::SolverChain(std::shared_ptr<const ContactSolver> split,
                           const SolverControls                &controls)
    : split(std::move(split))
    , newton(std::make_shared<CoupledNewton>(controls))
    , controls(controls)
  {}

  bool SolverChain::attempt(const ContactSolver  &solver,
                            const ContactProblem &problem,
                            ContactState          from,
                            SolverReport         &report,
                            ContactState         &state) const
  {
    const SolverReport next = solver.solve(problem, from);
    report.add_work(next);
    if (!next.converged)
      return false;
    report.converged = true;
    report.residual  = next.residual;
    report.reason.clear();
    report.solver += ", fallback " + next.solver;
    report.used_fallback = true;
    report.edges_settled = next.edges_settled;
    if (!from.edge_law)
      report.solver += " without edge law";
    state = from;
    return true;
  }

  SolverReport SolverChain::solve(const ContactProblem &problem,
                                  ContactState         &state) const
  {
    complete(problem, state);
    state.edge_law            = true;
    const ContactState start  = state;
    SolverReport       report = split->solve(problem, state);
    if (report.converged || problem.n_tangential() == 0)
      return report;
    if (attempt(*newton, problem, state, report, state) ||
        problem.operators.time_scaling().rate != 0.)
      return report;
    ContactState plain  = start;
    plain.edge_law      = false;
    const bool edge_law = problem.operators.slip_operator().has_edge_law();
    if (edge_law && (attempt(*split, problem, plain, report, state) ||
                     attempt(*newton, problem, plain, report, state)))
      return report;
    const RollingMarch march(
      std::make_shared<InTurn>(
        std::vector<std::shared_ptr<const ContactSolver>>{newton, split}),
      controls);
    if (!attempt(march, problem, start, report, state) && edge_law)
      attempt(march, problem, plain, report, state);
    return report;
  }
} // namespace RollingContact
