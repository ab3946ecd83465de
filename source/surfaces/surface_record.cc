#include <boost/crc.hpp>
#include <boost/math/interpolators/makima.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/text_table.h>
#include <rolling_contact/surfaces/height_map.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    const std::size_t least_heights = 10;

    const double largest_gap = 2.5;  // over the median of the spacings
    const double uneven      = 0.01; // of a spacing

    /**
     * Points of a line as in its file, and complaints about them.
     */
    struct RecordFile : public SurfaceFile
    {
      explicit RecordFile(const SurfaceFile &file)
        : SurfaceFile(file)
      {
        read(file.column());
      }

      void read(const std::size_t column);

      std::vector<double>      positions, heights;
      std::vector<std::size_t> lines;
    };

    void RecordFile::read(const std::size_t column)
    {
      TextLines file(path);
      bool      has_names = false;
      while (file.next())
        {
          const auto cells    = cells_of(file.text);
          const auto position = number(cells[0]);
          if (!number_of(cells[0]) && positions.empty() && !has_names)
            {
              has_names = true;
              continue;
            }
          if (cells.size() < column)
            reject("there is no column " + std::to_string(column) +
                     "; give the position and the height, or the column of the "
                     "height as in \"table: FILE 3\".",
                   file.number);
          const auto height = number(cells[column - 1]);
          if (!position || !height)
            reject(
              "\"" + quotable(file.text) +
                "\" has no finite position and height; mend or interpolate "
                "what was not measured" +
                advice_on_decimals(file.text) + ".",
              file.number);
          if (!positions.empty() && *position <= positions.back())
            reject("the position does not rise.", file.number);
          positions.push_back(*position);
          heights.push_back(*height);
          lines.push_back(file.number);
        }
      if (positions.size() < least_heights)
        reject("it has " + std::to_string(positions.size()) + " points; " +
               std::to_string(least_heights) + " are the least.");
    }

    double median_spacing(const std::vector<double> &positions)
    {
      std::vector<double> spacings(positions.size());
      std::adjacent_difference(positions.begin(),
                               positions.end(),
                               spacings.begin());
      const auto middle = spacings.begin() + 1 + (spacings.size() - 1) / 2;
      std::nth_element(spacings.begin() + 1, middle, spacings.end());
      return *middle;
    }

    void check_gaps(const RecordFile &file, const double unit)
    {
      const auto  &at     = file.positions;
      const double median = median_spacing(at);
      for (std::size_t k = 1; k < at.size(); ++k)
        if (at[k] - at[k - 1] > largest_gap * median)
          file.reject("a gap: " + significant(unit * (at[k] - at[k - 1]), 4) +
                        " m from the position before, where most are " +
                        significant(unit * median, 4) +
                        " m apart (at most 2.5 times that is taken). Fill it, "
                        "or cut the record there.",
                      file.lines[k]);
    }

    void check_heights(const RecordFile  &file,
                       const RecordUnits &units,
                       const double       mean)
    {
      const std::string hint =
        " Heights are taken as multiples of Surfaces/Height unit = " +
        significant(units.height, 4) +
        " m and positions of Surfaces/Position unit = " +
        significant(units.position, 4) +
        " m: of micrometres the unit is 1e-6, of millimetres 1e-3.";
      for (std::size_t k = 0; k < file.heights.size(); ++k)
        {
          const double height = units.height * file.heights[k] - mean;
          if (std::abs(height) > highest_surface)
            file.reject("a height of " + significant(height, 4) +
                          " m about the mean is too large for a surface that "
                          "a wheel rolls on (at most 5e-3 m)." +
                          hint,
                        file.lines[k]);
          if (k == 0)
            continue;
          const double slope =
            units.height * (file.heights[k] - file.heights[k - 1]) /
            (units.position * (file.positions[k] - file.positions[k - 1]));
          if (std::abs(slope) > steepest_surface)
            file.reject("a slope of " + significant(slope, 3) +
                          " is too steep for a surface that a wheel rolls on "
                          "(at most 0.1)." +
                          hint,
                        file.lines[k]);
        }
    }

    /** The points at equal spacing. */
    void space_evenly(std::vector<double> positions,
                      std::vector<double> heights,
                      SurfaceRecord      &record)
    {
      const double length    = positions.back() - positions.front();
      const auto   intervals = static_cast<std::size_t>(
        std::max(1., std::round(length / median_spacing(positions))));
      record.begin     = positions.front();
      record.spacing   = length / intervals;
      record.resampled = intervals + 1 != positions.size();
      for (std::size_t k = 0; k < positions.size() && !record.resampled; ++k)
        record.resampled =
          std::abs(positions[k] - record.begin - k * record.spacing) >
          uneven * record.spacing;
      if (!record.resampled)
        {
          record.heights = std::move(heights);
          return;
        }
      const double last = positions.back();
      const boost::math::interpolators::makima<std::vector<double>> curve(
        std::move(positions), std::move(heights));
      for (std::size_t k = 0; k <= intervals; ++k)
        record.heights.push_back(
          curve(std::min(last, record.begin + k * record.spacing)));
    }

    SurfaceRecord record_of_line(const RecordFile  &file,
                                 const RecordUnits &units)
    {
      check_gaps(file, units.position);
      SurfaceRecord record;
      record.mean =
        units.height *
        std::accumulate(file.heights.begin(), file.heights.end(), 0.) /
        file.heights.size();
      check_heights(file, units, record.mean);
      std::vector<double> positions = file.positions, heights = file.heights;
      for (double &position : positions)
        position *= units.position;
      for (double &height : heights)
        height = units.height * height - record.mean;
      space_evenly(std::move(positions), std::move(heights), record);
      return record;
    }

    /** The line of a map next to y = 0, about its mean. */
    SurfaceRecord middle_line_of(const SurfaceFile &file, SurfaceRecord map)
    {
      const double place = -map.first_line / map.line_spacing;
      if (!(place >= -0.5 && place <= map.n_lines - 0.5))
        file.reject("its lines go from y = " + significant(map.first_line, 6) +
                    " to " + significant(map.last_line(), 6) +
                    " m: none is at y = 0.");
      const std::size_t n     = map.n_along(),
                        first = n * static_cast<std::size_t>(
                                      std::min(std::round(std::max(0., place)),
                                               map.n_lines - 1.));
      map.heights = std::vector<double>(map.heights.begin() + first,
                                        map.heights.begin() + first + n);
      map.n_lines = 1;
      const double own_mean =
        std::accumulate(map.heights.begin(), map.heights.end(), 0.) / n;
      for (double &height : map.heights)
        height -= own_mean;
      map.mean += own_mean;
      return map;
    }
  } // namespace

  bool names_a_record(const std::string &text)
  {
    const SurfaceFile::Source source = SurfaceFile::source_of(text);
    return source.kind != SurfaceFile::Kind::none || source.mirrored ||
           source.middle_line;
  }

  bool names_a_map(const std::string &text)
  {
    const SurfaceFile::Source source = SurfaceFile::source_of(text);
    return source.kind != SurfaceFile::Kind::none &&
           source.kind != SurfaceFile::Kind::line && !source.middle_line;
  }

  void check_dimension_of_file(const std::string &entry,
                               const std::string &text,
                               const unsigned int dimension)
  {
    if (dimension == 2 && names_a_map(text))
      throw InputError(entry + " = " + quotable(text, 200) +
                       ": in 2D there is no y; write `middle line:` in front "
                       "of the map for its line next to y = 0, or take "
                       "Dimension = 3.");
  }

  SurfaceRecord read_surface_record(const std::string           &entry,
                                    const std::string           &text,
                                    const std::filesystem::path &folder,
                                    const RecordUnits           &units,
                                    const bool                   stands)
  {
    const SurfaceFile file(entry, text, folder);
    SurfaceRecord     record =
      file.source.kind == SurfaceFile::Kind::line
            ? record_of_line(RecordFile(file), units)
            : surface_of_map(file, read_measured_map(file, units), stands);
    if (file.source.middle_line)
      record = middle_line_of(file, std::move(record));
    record.entry = entry;
    record.file  = file.path;
    return record;
  }

  std::string SurfaceRecord::fingerprint() const
  {
    boost::crc_32_type crc;
    for (const double height : heights)
      crc.process_bytes(&height, sizeof(height));
    return std::to_string(heights.size()) + " heights from " +
           significant(begin, 9) + " to " + significant(end(), 9) + " m, " +
           (is_map() ? "y = " + significant(first_line, 9) + " to " +
                         significant(last_line(), 9) + " m, "
                     : "") +
           "CRC-32 " + std::to_string(crc.checksum());
  }
} // namespace RollingContact
