#ifndef rolling_contact_run_results_table_h
#define rolling_contact_run_results_table_h

#include <rolling_contact/run/run_folder.h>

#include <any>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace RollingContact
{
  /**
   * The unit of a column, which its name ends with: "Pa" of max_pressure_Pa,
   * "mu N" of bound_force/muN; "1" if it has none.
   */
  std::string unit_of_column(const std::string &column);

  /**
   * Rows of a CSV file, columns in the order of first use, names with their
   * unit. results.csv has a row for each computed state and is rewritten whole
   * after every row, so an interrupt keeps the rows; beyond a thousand rows at
   * most once a second, and 20 MB a second, the rest at the end. Other files
   * are written by flush() alone, all rows or none. Does not own the folder.
   * All MPI ranks have the rows, the root writes them. A table without a folder
   * writes nothing.
   */
  class ResultsTable
  {
  public:
    /** A cell whose value is of any type; the file has the text. */
    struct Named
    {
      std::string text;
      std::any    value;
    };

    /** What a text of a column stands for in a row, by column. */
    using Readers = std::map<
      std::string,
      std::function<std::any(const std::string &text, const std::size_t row)>>;

    /** results.csv, row by row. */
    explicit ResultsTable(RunFolder &folder);

    /** Another file, when flush() is called. */
    ResultsTable(RunFolder &folder, const std::string &file_name);

    /** Rows of results.csv that this rank alone has, row by row in the file
     * that it keeps of them, see RunFolder::claim_for_ranks(). */
    static ResultsTable of_rank(RunFolder &folder, const unsigned int rank);

    ResultsTable() = default;

    /** Writes rows of results.csv not yet in the file; unfinished rows are
     * dropped. */
    ~ResultsTable();

    ResultsTable(const ResultsTable &)            = delete;
    ResultsTable &operator=(const ResultsTable &) = delete;

    /** Sets a cell of the current row: a bool, an integer, a floating-point
     * number, a text, or one of them that may be unknown: leave_empty(). */
    template <typename Value>
    void set(const std::string &column, const Value &value);
    template <typename Value>
    void set(const std::string &column, const std::optional<Value> &value);

    /** Sets the cell of a value that is @p known, else leave_empty(). */
    template <typename Value>
    void set_if(const bool known, const std::string &column, const Value &value)
    {
      known ? set(column, value) : leave_empty(column);
    }

    /** Sets a cell that stands in the file as a text and is read as value(). */
    template <typename Value>
    void
    set(const std::string &column, const std::string &text, const Value &value);

    /** The column exists, its cell of the current row has no value. */
    void leave_empty(const std::string &column);

    /** Finishes the current row. */
    void end_row();

    /** Sets all cells of a row of another table in the current row; a column
     * that it leaves empty exists here as well. */
    void take_row(const ResultsTable &other, const std::size_t row);

    /** Adds all rows of another table at once: a file that is written has all
     * of them or none. The table with more columns gives their order, so that
     * it is the same whichever rows come first. */
    void append(const ResultsTable &other);

    /** Forgets all rows of a table without a folder. */
    void clear();

    /** Adds the rows of a file that csv() wrote: texts where there are readers,
     * else what looks like a number is one. Throws InputError naming the
     * @p file if it is none. */
    void restore(const std::string &text,
                 const std::string &file,
                 const Readers     &readers = {});

    /** Puts the rows into the order of a column of numbers; all of them have
     * it. */
    void sort_by(const std::string &column);

    /** Puts the columns of these names first, in their order; the others
     * follow in theirs. */
    void lead_with(const std::vector<std::string> &names);

    /** Writes rows not yet in the file. */
    void flush();

    std::size_t n_rows() const;

    const std::vector<std::string> &columns() const
    {
      return column_names;
    }

    /** Whether none of the cells of a column is a text. */
    bool has_numbers(const std::string &column) const;

    /** A cell with all its digits, a bool as 0 or 1; nothing if it was never
     * set or is not a number. */
    std::optional<double> number(const std::size_t  row,
                                 const std::string &column) const;

    /** As number(), with the digits that the file has, which a run that is
     * resumed reads. */
    std::optional<double> written_number(const std::size_t  row,
                                         const std::string &column) const;

    /** A cell as it stands in the file, but not quoted; empty if it was never
     * set. */
    std::string text(const std::size_t row, const std::string &column) const;

    /** The value of a cell that was set with a text; null if it has none of
     * this type. */
    template <typename Value>
    const Value *value(const std::size_t row, const std::string &column) const;

    /** Numbers with 9 significant digits; a cell never set is empty. */
    std::string csv() const;

    /** For the screen: those of the columns that exist, 4 significant digits,
     * "-" for a cell never set. One row in @p stride is shown. */
    std::string screen_table(const std::vector<std::string> &columns,
                             const std::size_t               stride = 1) const;

  private:
    using Cell = std::variant<std::monostate,
                              bool,
                              std::int64_t,
                              double,
                              std::string,
                              std::shared_ptr<const Named>>;
    using Row  = std::vector<Cell>; ///< by column; those behind it are empty

    std::size_t index_of(const std::string &column);

    void set_cell(const std::string &column, const Cell &cell);

    /** An empty one if it was never set or there is no such column. */
    const Cell &cell(const std::size_t row, const std::string &column) const;

    std::string csv_of(const Row &row) const;

    ResultsTable(RunFolder         &folder,
                 const std::string &file_name,
                 const bool         is_of_rank);

    void write_now_and_then();

    void update_csv() const;

    RunFolder                         *folder     = nullptr;
    bool                               row_by_row = false;
    bool                               is_of_rank = false;
    std::string                        file_name;
    std::vector<std::string>           column_names;
    std::map<std::string, std::size_t> column_numbers;
    std::vector<Row>                   rows;
    Row                                current_row;

    std::size_t                           n_written_rows = 0;
    std::chrono::steady_clock::time_point last_write;

    /** csv() of the first rows, with so many columns. */
    mutable std::string csv_text;
    mutable std::size_t n_csv_rows = 0, n_csv_columns = 0;
  };

  template <typename Value>
  void ResultsTable::set(const std::string &column, const Value &value)
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

  template <typename Value>
  void ResultsTable::set(const std::string          &column,
                         const std::optional<Value> &value)
  {
    value ? set(column, *value) : leave_empty(column);
  }

  template <typename Value>
  void ResultsTable::set(const std::string &column,
                         const std::string &text,
                         const Value       &value)
  {
    set_cell(column, std::make_shared<const Named>(Named{text, value}));
  }

  template <typename Value>
  const Value *ResultsTable::value(const std::size_t  row,
                                   const std::string &column) const
  {
    const auto *named =
      std::get_if<std::shared_ptr<const Named>>(&cell(row, column));
    return named ? std::any_cast<Value>(&(*named)->value) : nullptr;
  }
} // namespace RollingContact

#endif
