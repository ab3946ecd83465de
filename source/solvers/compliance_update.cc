#include <rolling_contact/base/broadcast.h>
#include <rolling_contact/solvers/compliance_update.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Solve the contact laws on the root and give state and report to all
     * ranks. Collective.
     */
    SolverReport solve_on_root(const ContactSolver  &solver,
                               const ContactProblem &problem,
                               ContactState         &state)
    {
      SolverReport report;
      Ranks::on_root([&]() { report = solver.solve(problem, state); });
      Ranks::broadcast(report);
      Ranks::broadcast(state);
      return report;
    }

    /**
     * Nodal forces that vary smoothly on the patch: p, p x/a and p y/a in each
     * component, with a half the size of the patch. The edge law needs W as an
     * operator, not only for the forces of the state, and the error of an
     * approximate W is smooth. Units: N.
     */
    std::vector<std::vector<double>> smooth_loads(const ContactProblem &problem,
                                                  const ContactState   &state)
    {
      const std::size_t n    = problem.n_nodes();
      double            size = 0.;
      for (std::size_t i = 0; i < n; ++i)
        if (state.pressure[i] > 0.)
          size = std::max({size,
                           std::abs(problem.operators.positions()[i][0]),
                           std::abs(problem.operators.positions()[i][1])});
      std::vector<std::vector<double>> loads;
      for (unsigned int c = 0; c <= problem.n_tangential() && size > 0.; ++c)
        for (unsigned int moment = 0; moment <= problem.n_tangential();
             ++moment)
          {
            std::vector<double> field = state.pressure;
            for (std::size_t i = 0; i < n && moment > 0; ++i)
              field[i] *= problem.operators.positions()[i][moment - 1] / size;
            const auto forces = problem.operators.H().multiply(field);
            loads.emplace_back((problem.n_tangential() + 1) * n, 0.);
            std::copy(forces.begin(),
                      forces.end(),
                      loads.back().begin() + c * n);
          }
      return loads;
    }

    /**
     * Update W by the response to the forces of a state and, the first time
     * that an edge law is in use, to smooth loads. Collective.
     */
    void secant_update(const PairResponse &response,
                       const ContactState &state,
                       ContactProblem     &problem)
    {
      const auto update = [&](const auto &loads, const bool roughly) {
        const auto displacements = response(loads, roughly);
        for (std::size_t k = 0; k < loads.size(); ++k)
          problem.operators.correct(loads[k], displacements[k]);
      };
      if (!problem.operators.is_corrected() && problem.n_tangential() > 0 &&
          problem.operators.slip_operator().has_edge_law())
        update(smooth_loads(problem, state), true);
      update(std::vector<std::vector<double>>{nodal_forces(problem, state)},
             false);
    }
  } // namespace

  SolverReport solve_updating_compliance(const ContactSolver  &solver,
                                         const PairResponse   &response,
                                         const bool            exact,
                                         const SolverControls &controls,
                                         ContactProblem       &problem,
                                         ContactState         &state)
  {
    SolverReport report = solve_on_root(solver, problem, state);
    if (exact)
      return report;
    const unsigned int max_corrections = 40;
    for (unsigned int correction = 0; report.converged; ++correction)
      {
        secant_update(response, state, problem);
        report.residual =
          natural_residual(problem, tangential_problem(problem, state), state);
        report.history.push_back(report.residual);
        report.corrections = correction;
        if (report.residual.worst() <= controls.tolerance)
          break;
        if (correction == max_corrections)
          {
            report.converged = false;
            report.reason    = "the bodies' response still changes the contact "
                               "after " +
                            std::to_string(correction) + " corrections";
            break;
          }
        const SolverReport next = solve_on_root(solver, problem, state);
        report.add_work(next);
        report.corrections   = correction + 1;
        report.solver        = next.solver;
        report.used_fallback = next.used_fallback;
        report.edges_settled = next.edges_settled;
        report.converged     = next.converged;
        report.reason        = next.reason;
        report.residual      = next.residual;
      }
    return report;
  }
} // namespace RollingContact
