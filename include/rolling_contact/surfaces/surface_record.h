#ifndef rolling_contact_surfaces_surface_record_h
#define rolling_contact_surfaces_surface_record_h

#include <filesystem>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Units of the numbers in a file of a surface. Units: m.
   */
  struct RecordUnits
  {
    double position = 1.;
    double height   = 1.;
  };

  /**
   * Measured heights of the running surface of a wheel or a rail, at positions
   * of equal spacing that count as the wheel runs: along a line, and the same
   * across, about their mean; or a map of several lines, each at its y, about
   * their plane. Units: m.
   */
  struct SurfaceRecord
  {
    std::string         entry, file; ///< for messages
    double              begin   = 0.;
    double              spacing = 0.;
    std::vector<double> heights;        ///< line after line
    double              mean      = 0.; ///< of the file, taken out
    bool                resampled = false;

    std::size_t n_lines        = 1;  ///< 1: the same across
    double      first_line     = 0.; ///< its y
    double      line_spacing   = 0.;
    double      slope_along    = 0.; ///< of the plane of a map, taken out
    double      slope_across   = 0.;
    std::size_t n_interpolated = 0; ///< points that were not measured

    bool is_map() const
    {
      return n_lines > 1;
    }

    std::size_t n_along() const
    {
      return heights.size() / n_lines;
    }

    double end() const
    {
      return begin + spacing * (n_along() - 1.);
    }

    double last_line() const
    {
      return first_line + line_spacing * (n_lines - 1.);
    }

    /**
     * Text that differs if the record differs: its size, ends and CRC-32.
     */
    std::string fingerprint() const;
  };

  /**
   * Whether the text of an entry names a file, as read_surface_record() takes
   * it, and no expression.
   */
  bool names_a_record(const std::string &text);

  /**
   * Whether the text of an entry names a file of many lines, a map, of which
   * not the middle line alone is taken.
   */
  bool names_a_map(const std::string &text);

  /** Throws InputError if the text of an entry names a map in 2D. */
  void check_dimension_of_file(const std::string &entry,
                               const std::string &text,
                               const unsigned int dimension);

  /** What read_surface_record() takes, for messages and help. */
  inline constexpr char kinds_of_surface_files[] =
    "a file, FILE.csv or table: FILE column (a line), FILE.sdf, grid: FILE or "
    "FILE.h5:/DATASET (a map; mirrored: or middle line: may stand in front)";

  /**
   * Read the file that the text of an entry names, relative to @p folder.
   *
   * `FILE.csv`, `table: FILE column`: the position in the first column, rising,
   * the height in the second or in the column of the given number; separated by
   * commas, semicolons or blanks, lines with # in front and a first line of
   * names do not count. Positions that are uneven, by less than 2.5 times their
   * median, are resampled by Akima's modified cubic; the mean is taken out.
   *
   * `FILE.sdf`, `grid: FILE`, `FILE.h5:/DATASET`: a map, see height_map.h, with
   * `mirrored:` in front of it with -y in place of y, and with `middle line:`
   * its line next to y = 0, as if it were a record. One without positions
   * begins at 0, or has its middle there if the surface @p stands.
   *
   * Throws InputError naming the entry, the file, the line and what is allowed:
   * what is not a number, gaps, heights beyond 5 mm about their mean and, of a
   * record, slopes beyond 0.1, which ask for another unit.
   */
  SurfaceRecord read_surface_record(const std::string           &entry,
                                    const std::string           &text,
                                    const std::filesystem::path &folder,
                                    const RecordUnits           &units,
                                    const bool stands = false);

  /** No surface on which a wheel rolls is higher about its mean, m. */
  inline constexpr double highest_surface = 5e-3;

  /** No such surface is steeper. */
  inline constexpr double steepest_surface = 0.1;
} // namespace RollingContact

#endif
