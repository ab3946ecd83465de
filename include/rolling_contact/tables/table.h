#ifndef rolling_contact_tables_table_h
#define rolling_contact_tables_table_h

#include <rolling_contact/base/turns.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/tables/load_bands.h>
#include <rolling_contact/tables/rows_of_ranks.h>

#include <vector>

namespace RollingContact
{
  /**
   * Analysis = table: the steady states of a grid or a file of rows, each with
   * its row of results.csv. Bodies are condensed once for all states that may
   * share them, states follow each other so that each starts from a neighbour,
   * in several threads and ranks, with numbers that do not depend on how many:
   * each rank makes the bodies that its chains need and is alone otherwise. A
   * run that was stopped goes on with what has no row. A state that is not
   * solved has a row that says so; the others go on, and run() throws
   * ConvergenceError when all is written.
   */
  template <int dim>
  class Table : public Analysis
  {
  public:
    /** The states are those of section Table. */
    Table(const Situation &scene, RunContext &context);

    Table(const Situation   &scene,
          const TableStates &states,
          RunContext        &context);

    void run() override;

  protected:
    /**
     * Add the columns of this analysis to the row of a state that is solved;
     * those of the state itself are there already. Several threads call this.
     */
    virtual void add_columns(const Situation &,
                             const SteadyState<dim> &,
                             ResultsTable &) const
    {}

    /**
     * Bodies are there, and a state on them, to solve others.
     */
    virtual void take_bodies(const Situation &, const SteadyState<dim> &)
    {}

    /**
     * All states on these bodies have their rows; the bodies will go.
     */
    virtual void
    leave_bodies(const LoadBand &, const Situation &, const SteadyState<dim> &)
    {}

    /**
     * What makes the pairs of a band; none: each makes bodies of its own.
     */
    virtual PairMaker<dim> pair_maker(const LoadBand &)
    {
      return {};
    }

    /**
     * The smallest patch that bodies serve, over the one they are made for.
     */
    virtual double smallest_share() const;

    /** Number of sets of bodies that states share, in words for the log. */
    virtual std::string sets(const std::size_t n) const;

    /**
     * What bodies and mesh must have, beyond what the scene says.
     */
    virtual StateDemands demands() const;

    /** And of those of a band, wherever profiles touch. */
    StateDemands demands_of(const LoadBand &band) const;

    /**
     * When all states have rows, in the order of their numbers.
     */
    virtual void draw();

    /**
     * Say what all rows together tell.
     */
    virtual void summarise()
    {}

    /** Whether other ranks solve some of the states, so that here are rows of
     * all states only in the end. */
    bool is_shared() const
    {
      return n_ranks > 1;
    }

    const Situation      &scene;
    const unsigned int    n_ranks;
    RowsOfRanks           rows_of_ranks;
    RunContext           &context; ///< to which this rank adds its rows
    const TablePlan       plan;
    std::vector<LoadBand> bands;

  private:
    /**
     * States of a chain, which are solved one after the other and each start
     * from the last: as many as a stopped run may lose in each thread.
     */
    static constexpr std::size_t chain_length = 32;

    using Chains = std::vector<std::vector<std::size_t>>;

    /** Another rank ends the run, and throws the reason. */
    struct StoppedElsewhere
    {};

    /**
     * Which chains of a band this rank takes, one by one; others take others.
     */
    struct BandTurns
    {
      bool any() const
      {
        return turns.has_below(first + n);
      }

      /** The number of a chain in the band. */
      std::optional<std::size_t> take() const
      {
        const auto turn = turns.take_below(first + n);
        return turn ? std::optional<std::size_t>(*turn - first) : std::nullopt;
      }

      /** Throws StoppedElsewhere if another rank has ended the run. */
      void go_on() const;

      /** All chains that are left, while others take some as well. */
      Chains rest_of(const Chains &chains) const;

      Ranks::Turns     &turns;
      const std::size_t first, n; ///< chains before the band, chains in it
    };

    /** Note the states that have rows: of a run before, or of parts. */
    void take_rows();

    /** Solve the chains of all bands, each by the rank that takes it; then the
     * root has the rows of all, also when something is thrown. Collective. */
    void solve_bands(const std::vector<Chains> &of_bands);

    void solve_own_turns(const std::vector<Chains> &of_bands,
                         Ranks::Turns              &turns);

    /**
     * The chains of a band, of this part of the table, of which there are no
     * rows yet. To be called once for each band, in their order.
     */
    Chains chains_of(const LoadBand &band);

    void solve_band(const LoadBand  &band,
                    const Chains    &chains,
                    const BandTurns &turns);

    void solve_band_that_touches(const LoadBand  &band,
                                 const Chains    &chains,
                                 const BandTurns &turns);

    void give_up(const Chains &unsolved, const std::string &why);

    /**
     * Solve chains on bodies, those that @p turns gives or without it all, and
     * return what is left of them because its patch reaches the border of the
     * zone.
     */
    Chains solve_chains(const Chains           &chains,
                        const BandTurns        *turns,
                        const SteadyState<dim> &base,
                        const Situation        &scene,
                        const bool              keep_all);

    /** Steady state of the same bodies with a larger zone of contact nodes. */
    SteadyState<dim> enlarged(const SteadyState<dim> &base,
                              const LoadBand         &band,
                              const Situation        &scene,
                              const unsigned int      n_elements,
                              const PairMaker<dim>   &make_pair);

    void describe(const LoadBand         &band,
                  const Situation        &scene,
                  const SteadyState<dim> &base,
                  const std::size_t       n_states);

    void finish();

    const TablePart                    part;
    const unsigned int                 n_threads;
    const std::shared_ptr<SplitBodies> split_bodies =
      std::make_shared<SplitBodies>();
    std::vector<bool> has_row;
    std::size_t       n_chains = 0, n_mine = 0; ///< chains; states of this part
    std::size_t       n_before = 0;     ///< rows of a run that is continued
    unsigned int      n_bodies = 0;     ///< sets of them that were built
    bool              is_said  = false; ///< why a state did not converge
    double            seconds  = 0.;    ///< of solving states
  };

  /**
   * What --resume goes on with.
   */
  RunFolder::Resumption table_resumption(const Situation &scene);

  AnalysisKind table_kind();
} // namespace RollingContact

#endif
