#ifndef rolling_contact_run_history_table_h
#define rolling_contact_run_history_table_h

#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/run/run_folder.h>

#include <cstdint>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A CSV file that grows by one row per time step and is never rewritten: it
   * has its temporary name in the run folder (RunFolder::growing(), to be read
   * there: whole rows, but for the very last) until it is published, at the end
   * or when the run stops with an exception. A killed run leaves it there, to
   * be continued from the position of a checkpoint. If the disk is full the
   * rows that are on it are published. Does not own the folder.
   * Throws InputError if the disk is full or the file gone. With several MPI
   * ranks only the root has a file; only the constructors are collective.
   */
  class HistoryTable
  {
  public:
    /** How much of the file belongs to a checkpoint. */
    struct Position
    {
      std::uint64_t n_rows  = 0;
      std::uint64_t n_bytes = 0;
    };

    /** Starts the file; column names with their unit. */
    HistoryTable(RunFolder                      &folder,
                 const std::string              &file_name,
                 const std::vector<std::string> &columns);

    /** Continues the file after the rows of a checkpoint, dropping the rest.
     * Throws InputError if it does not begin with these columns. */
    HistoryTable(RunFolder                      &folder,
                 const std::string              &file_name,
                 const std::vector<std::string> &columns,
                 const Position                 &position);

    /** Publishes the rows there are. */
    ~HistoryTable();

    HistoryTable(const HistoryTable &) = delete;
    HistoryTable &
    operator=(const HistoryTable &) = delete;

    /** One value per column, with 9 significant digits; integers below 10^9
     * are exact. Rows are in the file half a second later at most, if another
     * follows. */
    void
    add_row(const std::vector<double> &values);

    /** Returns when all rows are on the disk; where the file of the root
     * ends. */
    Position
    flush();

    /** The file is complete and gets its final name; no rows after this. */
    void
    publish();

  private:
    void
    open_at_end(const std::filesystem::path &path);
    void
    write_buffer();
    /** Of the rows in the buffer so many bytes could be written: the file ends
     * with a whole row, the buffer begins with the next. */
    void
    drop_half_a_row(const std::size_t n_written);
    void
    keep_what_is_there();

    RunFolder        &folder;
    const std::string file_name;
    const std::size_t n_columns;
    std::string       buffer;   ///< not written yet
    Position          position; ///< with the rows of the buffer
    Stopwatch         since_last_write;
    int               descriptor; ///< -1 once published
  };
} // namespace RollingContact

#endif
