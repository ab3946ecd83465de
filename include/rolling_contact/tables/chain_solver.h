#ifndef rolling_contact_tables_chain_solver_h
#define rolling_contact_tables_chain_solver_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/tables/table_rows.h>

#include <functional>
#include <vector>

namespace RollingContact
{
  /**
   * The rows of consecutive states, and those of them whose patch reached the
   * border of the candidate zone, which have no row yet.
   */
  struct SolvedChain
  {
    ResultsTable             rows;
    std::vector<std::size_t> not_enclosed;
    std::string complaint; ///< why its first state that is not found is not
  };

  /**
   * Solves states one after the other on bodies that are at hand, each from the
   * one before, the first from the one that the bodies were made with. What it
   * finds depends on nothing but bodies and states; for one thread at a time.
   */
  template <int dim>
  class ChainSolver
  {
  public:
    /** Adds columns to the row of a state that is solved. */
    using MoreColumns = std::function<
      void(const Situation &, const SteadyState<dim> &, ResultsTable &)>;

    /**
     * @p scene: any of the table, @p base: bodies and a state on them. Keeps
     * references to plan and base, and the folder and the log of the context.
     */
    ChainSolver(const Situation        &scene,
                const TablePlan        &plan,
                const SteadyState<dim> &base,
                const MoreColumns      &more_columns,
                RunContext             &context);

    /**
     * Unless @p keep_all, states that are not enclosed in the zone get no row.
     * Throws Interrupted between two states.
     */
    void solve(const std::vector<std::size_t> &states,
               const bool                      keep_all,
               SolvedChain                    &chain);

  private:
    /** Begin where the bodies were made, with the creepages found there. */
    void restart();

    /**
     * True if the state is enclosed in the zone.
     */
    bool solve_state(const Situation &scene);

    void add_row(const std::size_t state,
                 const Situation  &scene,
                 const bool        enclosed,
                 SolvedChain      &chain);

    SceneEntries            entries;
    const TablePlan        &plan;
    const SteadyState<dim> &base;
    const MoreColumns       more_columns;
    RunContext             &context;
    SteadyState<dim>        steady;
    bool                    is_continued = false;
  };
} // namespace RollingContact

#endif
