#ifndef rolling_contact_tables_table_output_h
#define rolling_contact_tables_table_output_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/tables/table_rows.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What must be said of all rows of a table together.
   */
  struct TableSummary
  {
    std::map<TableStatus, std::vector<std::size_t>> states;
    std::optional<double> largest_bound; ///< of the force, over mu N
    std::size_t           n_without_bound = 0, n_fallbacks = 0;

    void note(RunReport &report) const;

    void warn(const TablePlan &plan, Log &log) const;

    /**
     * Throws ConvergenceError unless all states are solved or do not touch.
     */
    void require_solved(const TablePlan &plan) const;
  };

  TableSummary summary_of(const ResultsTable &results);

  /**
   * table.h5: axes, every quantity of results.csv as an array over them with
   * its unit, NaN for states that are not solved, and the bounds of the errors
   * in the units of what they bound.
   */
  void write_table_file(const TablePlan &plan,
                        const Situation &scene,
                        RunContext      &context);

  /**
   * table_1.svg and so on: forces and moment over each axis, a line for some
   * values of the next one, the others in their middle.
   */
  void plot_sections(const TablePlan &plan, RunContext &context);
} // namespace RollingContact

#endif
