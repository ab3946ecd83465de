#ifndef rolling_contact_tables_table_rows_h
#define rolling_contact_tables_table_rows_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/tables/table_plan.h>

#include <set>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What became of a state of a table, as column status has it.
   */
  enum class TableStatus
  {
    solved,
    no_contact,
    broken,
    not_converged,
    not_enclosed
  };

  /**
   * "no contact".
   */
  std::string name_of(const TableStatus status);

  /**
   * A vibration as column vibrations of a stability map has it, "1035.1:1.042".
   */
  struct ListedVibration
  {
    double frequency = 0.; ///< Hz
    double growth    = 0.; ///< 1/s

    std::string mode = {}; ///< that has most of it, where it was asked for
  };

  std::string text_of(const std::vector<ListedVibration> &vibrations);

  /**
   * Throws InputError naming the row if it is none.
   */
  std::vector<ListedVibration> vibrations_of(const std::string &text,
                                             const std::size_t  row);

  /**
   * Begin the row of a state: its number, its entries and what became of it.
   */
  void begin_table_row(const TablePlan  &plan,
                       const std::size_t state,
                       const TableStatus status,
                       ResultsTable     &rows);

  /**
   * Add the row of a state of which nothing is known but its status.
   */
  void add_unsolved_row(const TablePlan  &plan,
                        const std::size_t state,
                        const TableStatus status,
                        ResultsTable     &rows);

  /**
   * The state that a row is of.
   */
  std::size_t state_of_row(const ResultsTable &results, const std::size_t row);

  TableStatus status_of_row(const ResultsTable &results, const std::size_t row);

  /**
   * Read the rows that a stopped run has left in the folder, in results.csv and
   * the files of its ranks. Throws InputError if they are not those of the
   * plan, as where the file of rows has changed.
   */
  void restore_rows(const TablePlan &plan, RunContext &context);

  /**
   * Add the rows in the files of ranks to those of the results, write
   * results.csv and remove the files. Rows that are there already are left out:
   * a run may have been killed before it removed them. Adds to @p numbers the
   * number of rows of each file. Throws InputError as restore_rows() does. Only
   * for the root.
   */
  void add_rows_of_ranks(const TablePlan          &plan,
                         RunContext               &context,
                         std::vector<std::size_t> &numbers);

  /**
   * Read the rows that the runs of all parts have left in these folders,
   * Table/Join, of scenes that may differ in some entries. Throws InputError
   * naming the folder if one is of another scene or has a state that another
   * one has, and the first state that none has.
   */
  void join_rows(const TablePlan      &plan,
                 const std::string    &folders,
                 std::set<std::string> may_differ,
                 RunContext           &context);
} // namespace RollingContact

#endif
