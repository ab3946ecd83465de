#ifndef rolling_contact_surfaces_height_map_file_h
#define rolling_contact_surfaces_height_map_file_h

#include <rolling_contact/surfaces/surface_file.h>
#include <rolling_contact/surfaces/surface_record.h>

#include <limits>
#include <vector>

namespace RollingContact
{
  /**
   * Heights on a grid as a file has them, line after line along x; NaN where
   * nothing was measured. Units: m.
   */
  struct MeasuredMap
  {
    std::size_t         n_x = 0, n_y = 0;
    double              x = 0., y = 0.; ///< of the first point
    double              dx = 0., dy = 0.;
    bool                has_places = true; ///< or about 0
    std::vector<double> heights;

    /** Where in a text each line along x begins, or all points of an x. */
    std::vector<std::size_t> text_lines;
    bool                     a_text_line_is_one_x = false;
  };

  /** Most points of a map, 134 MB. */
  inline constexpr std::size_t most_points_of_map = 4096 * 4096;

  /**
   * Read the file of a map.
   *
   * `grid`: the first row has y, each other one x and a height for each y, in
   * the given units; `BAD` is a point that was not measured.
   *
   * `sdf`: ISO 25178-71 as text (aISO-1.0 or 2.0, aBCR-1.0), whose scales are
   * in m: NumProfiles lines across of NumPoints along, `BAD` where nothing was
   * measured.
   *
   * `hdf5`: a dataset of lines across of points along, NaN where nothing was
   * measured, in the unit of height, with the attributes x_spacing and
   * y_spacing in m.
   *
   * Throws InputError naming the line: wrong numbers of points, what is no
   * number, positions that do not rise evenly, more than most_points_of_map.
   */
  MeasuredMap read_measured_map(const SurfaceFile &file,
                                const RecordUnits &units);

  /** Stands for a point that was not measured. */
  inline constexpr double not_measured =
    std::numeric_limits<double>::quiet_NaN();
} // namespace RollingContact

#endif
