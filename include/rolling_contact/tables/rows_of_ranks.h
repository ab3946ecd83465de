#ifndef rolling_contact_tables_rows_of_ranks_h
#define rolling_contact_tables_rows_of_ranks_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/tables/table_plan.h>

#include <string>

namespace RollingContact
{
  /**
   * The rows of a table that is solved by several ranks. The root writes those
   * that it solves to results.csv, every other rank to a file of its own, so
   * that nothing that is done is lost with a rank that is killed; in the end
   * the root has them all. With one rank there is nothing but results.csv.
   */
  class RowsOfRanks
  {
  public:
    /** @p of_run is kept: folder, log, report and timer are those of the run.
     */
    explicit RowsOfRanks(RunContext &of_run);

    /** The context to whose results this rank adds its rows. */
    RunContext &context()
    {
      return of_this_rank;
    }

    /** Make the files of ranks part of the run. Collective. */
    void claim();

    /**
     * Take the rows of all ranks into the results of the root, which writes
     * results.csv and removes the files of the others, and their warnings into
     * its log. Throws InputError on all ranks, as where a rank has written to
     * a folder that the root does not see. Collective.
     */
    void collect(const TablePlan &plan);

    /** "2 ranks, 48 to 64 states each"; empty on one rank. For the root, after
     * collect(). */
    std::string shares() const;

  private:
    void take_rows(const TablePlan &plan, const double n_solved);
    void take_warnings();

    RunContext        &of_run;
    const unsigned int n_ranks;
    ResultsTable       own_rows;
    RunContext         of_this_rank;
    std::size_t        n_before = 0; ///< rows that none of the ranks solved
    std::size_t        fewest = 0, most = 0;
  };
} // namespace RollingContact

#endif
