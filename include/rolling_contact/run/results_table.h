#ifndef rolling_contact_run_results_table_h
#define rolling_contact_run_results_table_h

#include <rolling_contact/run/run_folder.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace RollingContact
{
  /**
   * One row per computed state, columns in the order of first use, names with
   * their unit. The CSV file in the run folder is rewritten whole after every
   * row, so an interrupt keeps the rows; beyond a thousand rows at most once a
   * second, the rest at the end. Does not own the folder. All MPI ranks have
   * the rows, the root writes them.
   */
  class ResultsTable
  {
  public:
    explicit ResultsTable(RunFolder         &folder,
                          const std::string &file_name = "results.csv");

    /** Writes rows not yet in the file; unfinished rows are dropped. */
    ~ResultsTable();

    ResultsTable(const ResultsTable &) = delete;
    ResultsTable &
    operator=(const ResultsTable &) = delete;

    /** Sets a cell of the current row: a bool, an integer, a floating-point
     * number or a text. */
    template <typename Value>
    void
    set(const std::string &column, const Value &value);

    /** The column exists, its cell of the current row has no value. */
    void
    leave_empty(const std::string &column);

    /** Finishes the current row. */
    void
    end_row();

    /** Writes rows not yet in the file. */
    void
    flush();

    std::size_t
    n_rows() const;

    /** Numbers with 9 significant digits; a cell never set is empty. */
    std::string
    csv() const;

    /** For the screen: those of the columns that exist, 4 significant digits,
     * "-" for a cell never set. */
    std::string
    screen_table(const std::vector<std::string> &columns) const;

  private:
    using Cell = std::variant<bool, std::int64_t, double, std::string>;
    using Row  = std::map<std::string, Cell>;

    void
    set_cell(const std::string &column, const Cell &cell);

    RunFolder               &folder;
    const std::string        file_name;
    std::vector<std::string> column_names;
    std::vector<Row>         rows;
    Row                      current_row;

    std::size_t                           n_written_rows;
    std::chrono::steady_clock::time_point last_write;
  };



  template <typename Value>
  void
  ResultsTable::set(const std::string &column, const Value &value)
  {
    if constexpr (std::is_same_v<Value, bool>)
      set_cell(column, Cell(value));
    else if constexpr (std::is_integral_v<Value>)
      set_cell(column, Cell(static_cast<std::int64_t>(value)));
    else if constexpr (std::is_floating_point_v<Value>)
      set_cell(column, Cell(static_cast<double>(value)));
    else
      set_cell(column, Cell(std::string(value)));
  }
} // namespace RollingContact

#endif
