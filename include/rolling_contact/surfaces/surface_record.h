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
   * Measured heights along the running surface of a wheel or a rail, about
   * their mean, at positions of equal spacing that count as the wheel runs.
   * Units: m.
   */
  struct SurfaceRecord
  {
    std::string         entry, file; ///< for messages
    double              begin   = 0.;
    double              spacing = 0.;
    std::vector<double> heights;
    double              mean      = 0.; ///< of the file, taken out
    bool                resampled = false;

    double end() const
    {
      return begin + spacing * (heights.size() - 1.);
    }

    /**
     * Text that differs if the record differs: its size, ends and CRC-32.
     */
    std::string fingerprint() const;
  };

  /**
   * Whether the text of an entry names a file, `FILE.csv` or `table: FILE
   * column`, and no expression.
   */
  bool names_a_record(const std::string &text);

  /**
   * Read the file that the text of an entry names, relative to @p folder: the
   * position in the first column, rising, the height in the second or in the
   * column of the given number; separated by commas, semicolons or blanks,
   * lines with # in front and a first line of names do not count. Positions
   * that are uneven, by less than 2.5 times their median, are resampled by
   * Akima's modified cubic. Throws InputError naming the entry, the file, the
   * line and what is allowed: what is no number, gaps, heights beyond 5 mm
   * about their mean and slopes beyond 0.1, which ask for another unit.
   */
  SurfaceRecord read_surface_record(const std::string           &entry,
                                    const std::string           &text,
                                    const std::filesystem::path &folder,
                                    const RecordUnits           &units);

  /** No surface on which a wheel rolls is higher about its mean, m. */
  inline constexpr double highest_surface = 5e-3;

  /** No such surface is steeper. */
  inline constexpr double steepest_surface = 0.1;
} // namespace RollingContact

#endif
