#ifndef rolling_contact_run_history_table_h
#define rolling_contact_run_history_table_h

#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/run/run_folder.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace RollingContact
{
  /** Values over the rows of a history, with all digits, by column. */
  using HistoryColumns = std::map<std::string, std::vector<double>>;

  /**
   * The binary file beside the CSV file of a history: history.bin.
   */
  std::string numbers_of(const std::string &file_name);

  /**
   * A CSV file that grows by one row per time step and is never rewritten, and
   * beside it the same numbers with all digits (numbers_of(), 8 bytes each, row
   * by row), from which the program reads: a run that was resumed has the same
   * as one that was not, and the memory does not grow with the run. Both have
   * their temporary names in the run folder (RunFolder::growing(), to be read
   * there: whole rows, but for the very last) until they are published, at the
   * end or when the run stops with an exception. A killed run leaves them
   * there, to be continued from the position of a checkpoint. If the disk is
   * full the rows that are on it are published. Does not own the folder.
   * Throws InputError if the disk is full or a file gone. With several MPI
   * ranks only the root has files; only the constructors are collective.
   */
  class HistoryTable
  {
  public:
    /** How much of the CSV file belongs to a checkpoint. */
    struct Position
    {
      std::uint64_t n_rows  = 0;
      std::uint64_t n_bytes = 0;
    };

    /** Starts the files; column names with their unit. Without numbers there
     * is the CSV file alone, and nothing to be read. */
    HistoryTable(RunFolder                      &folder,
                 const std::string              &file_name,
                 const std::vector<std::string> &columns,
                 const bool                      keeps_numbers = true);

    /** Continues the files after the rows of a checkpoint, dropping the rest.
     * Throws InputError if the CSV file does not begin with these columns. */
    HistoryTable(RunFolder                      &folder,
                 const std::string              &file_name,
                 const std::vector<std::string> &columns,
                 const Position                 &position);

    /** Publishes the rows there are. */
    ~HistoryTable();

    HistoryTable(const HistoryTable &)            = delete;
    HistoryTable &operator=(const HistoryTable &) = delete;

    /** One value per column, in the CSV file with 9 significant digits;
     * integers below 10^9 are exact there. Rows are in the files half a second
     * later at most, if another follows. */
    void add_row(const std::vector<double> &values);

    /** Returns when all rows are on the disk; where the CSV file of the root
     * ends. */
    Position flush();

    /** The files are complete and get their final names; no rows after this. */
    void publish();

    /** How many rows were added, those before a resumption included. */
    std::size_t size() const
    {
      return n_rows;
    }

    /** The rows that are in the files, all if none was added since flush() or
     * publish(); a column that the history does not have is empty. */
    HistoryColumns columns(const std::vector<std::string> &wanted) const;

  private:
    /** One of the files. */
    struct Stream
    {
      std::string   name;
      std::string   buffer;          ///< not written yet
      std::uint64_t n_bytes    = 0;  ///< with those of the buffer
      int           descriptor = -1; ///< once published
    };

    std::size_t row_bytes() const
    {
      return sizeof(double) * names.size();
    }

    void open_at_end(const std::filesystem::path &path, Stream &stream);
    void write(Stream &stream);
    void write_buffers();
    /**
     * Cut the file after its last whole row, and the buffer before the next
     * one, when only @p n_written bytes of the buffer could be written.
     */
    void drop_half_a_row(const std::size_t n_written, Stream &stream);
    void keep_what_is_there();

    RunFolder                     &folder;
    const std::vector<std::string> names;
    std::vector<Stream>            streams; ///< CSV, numbers
    std::uint64_t                  n_rows       = 0;
    bool                           is_published = false;
    Stopwatch                      since_last_write;
  };
} // namespace RollingContact

#endif
