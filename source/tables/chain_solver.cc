#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/tables/chain_solver.h>
#include <rolling_contact/tables/kept_bodies.h>

namespace RollingContact
{
  template <int dim>
  ChainSolver<dim>::ChainSolver(const Situation        &scene,
                                const TablePlan        &plan,
                                const SteadyState<dim> &base,
                                const MoreColumns      &more_columns,
                                RunContext             &context)
    : entries(scene)
    , plan(plan)
    , base(base)
    , more_columns(more_columns)
    , context(context)
    , steady(base)
  {}

  template <int dim>
  void ChainSolver<dim>::restart()
  {
    steady.state                   = base.state;
    steady.solver                  = base.solver;
    steady.problem.loads.forces    = base.problem.loads.forces;
    steady.problem.loads.creepages = base.problem.loads.creepages;
  }

  template <int dim>
  bool ChainSolver<dim>::solve_state(const Situation &scene)
  {
    solve_on_kept_bodies(scene, steady);
    if (!steady.solver.converged && is_continued)
      {
        restart();
        solve_on_kept_bodies(scene, steady);
      }
    // a state that is none is nothing to start from
    is_continued = steady.solver.converged;
    return !steady.solver.converged || !zone_too_small(steady);
  }

  template <int dim>
  void ChainSolver<dim>::solve(const std::vector<std::size_t> &states,
                               const bool                      keep_all,
                               SolvedChain                    &chain)
  {
    is_continued = false;
    for (const std::size_t state : states)
      {
        throw_if_interrupted();
        plan.set(state, entries);
        Situation scene = entries.situation();
        take_economical_solver(scene);
        if (!is_continued)
          restart();
        const bool enclosed = solve_state(scene);
        if (enclosed || keep_all)
          add_row(state, scene, enclosed, chain);
        else
          chain.not_enclosed.push_back(state);
      }
  }

  template <int dim>
  void ChainSolver<dim>::add_row(const std::size_t state,
                                 const Situation  &scene,
                                 const bool        enclosed,
                                 SolvedChain      &chain)
  {
    ResultsTable row, whole;
    RunContext   own{
      context.folder, row, context.report, context.timer, context.log};
    TableStatus status = !steady.solver.converged ? TableStatus::not_converged
                         : !enclosed              ? TableStatus::not_enclosed
                                                  : TableStatus::solved;
    if (!steady.solver.converged && chain.complaint.empty())
      chain.complaint = "The state of the table with " + plan.name(state) +
                        " did not converge: " + steady.solver.reason + ".";
    try
      {
        estimate_errors(scene, steady);
        add_result_row(scene, steady, own);
      }
    catch (const ConvergenceError &)
      {
        status = TableStatus::broken;
      }
    begin_table_row(plan, state, status, whole);
    whole.take_row(row, 0);
    if (status == TableStatus::solved)
      more_columns(scene, steady, whole);
    whole.end_row();
    chain.rows.append(whole);
  }

  template class ChainSolver<2>;
  template class ChainSolver<3>;
} // namespace RollingContact
