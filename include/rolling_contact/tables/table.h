#ifndef rolling_contact_tables_table_h
#define rolling_contact_tables_table_h

#include <rolling_contact/analyses/analysis.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/tables/load_bands.h>

#include <vector>

namespace RollingContact
{
  /**
   * Analysis = table: the steady states of a grid or a file of rows, each with
   * its row of results.csv. Bodies are condensed once for all states that may
   * share them, states follow each other so that each starts from a neighbour,
   * in several threads, with numbers that do not depend on how many. A run that
   * was stopped goes on where its results.csv ends. A state that is not solved
   * has a row that says so; the others go on, and run() throws ConvergenceError
   * when all is written.
   */
  template <int dim>
  class Table : public Analysis
  {
  public:
    Table(const SceneParameters &scene, RunContext &context);

    void
    run() override;

  private:
    /**
     * So many states, one after the other, start from a common one: what a
     * stopped run may lose in each thread.
     */
    static constexpr std::size_t chain_length = 32;

    using Chains = std::vector<std::vector<std::size_t>>;

    /**
     * The chains of a band of which there are no rows yet.
     */
    Chains
    chains_of(const LoadBand &band) const;

    void
    solve_band(const LoadBand &band);

    void
    solve_band_that_touches(const LoadBand &band, const Chains &chains);

    /**
     * Solve chains on bodies, and return what is left of them because its patch
     * reaches the border of the zone.
     */
    Chains
    solve_chains(const Chains           &chains,
                 const SteadyState<dim> &base,
                 const SceneParameters  &scene,
                 const bool              keep_all);

    /**
     * The same bodies with a larger zone.
     */
    SteadyState<dim>
    enlarged(const SteadyState<dim> &base,
             const SceneParameters  &scene,
             const unsigned int      n_elements);

    void
    describe(const LoadBand         &band,
             const SceneParameters  &scene,
             const SteadyState<dim> &base,
             const std::size_t       n_states);

    void
    finish();

    const SceneParameters &scene;
    RunContext            &context;
    const unsigned int     n_threads;
    TablePlan              plan;
    std::vector<bool>      has_row;
    std::size_t            n_before = 0;  ///< rows of a run that is continued
    unsigned int           n_bodies = 0;  ///< sets of them that were built
    double                 seconds  = 0.; ///< of solving states
  };
} // namespace RollingContact

#endif
