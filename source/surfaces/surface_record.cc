#include <boost/algorithm/string.hpp>
#include <boost/crc.hpp>
#include <boost/math/interpolators/makima.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/text_table.h>
#include <rolling_contact/surfaces/surface_record.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace RollingContact
{
  namespace
  {
    const std::size_t least_heights = 10, most_bytes = 200'000'000;

    const double largest_gap = 2.5;  // over the median of the spacings
    const double uneven      = 0.01; // of a spacing

    const std::string keyword = "table:";

    /** What the text of the entry names. */
    struct Source
    {
      std::string file;
      std::size_t column = 2;
    };

    /**
     * Reads a file into points and complains about its lines.
     */
    class RecordFile
    {
    public:
      RecordFile(const std::string           &entry,
                 const std::string           &text,
                 const std::filesystem::path &folder)
        : entry(entry)
        , text(text)
      {
        const Source source = source_of_text();
        path                = folder / source.file;
        read(source.column);
      }

      [[noreturn]] void reject(const std::string &reason,
                               const std::size_t  line = 0) const
      {
        throw InputError(
          entry + " = " + quotable(text, 200) + ": " +
          (path.empty() ? std::string() : '"' + path.string() + '"') +
          (line > 0 ? ", line " + std::to_string(line) : "") + ": " + reason);
      }

      std::filesystem::path file() const
      {
        return path;
      }

      std::vector<double>      positions, heights; ///< as in the file
      std::vector<std::size_t> lines;

    private:
      Source source_of_text() const
      {
        if (text.compare(0, keyword.size(), keyword) != 0)
          return {text};
        std::string rest  = trimmed(text.substr(keyword.size()));
        const auto  space = rest.find_last_of(" \t");
        if (space == std::string::npos)
          return {rest};
        const std::string column = rest.substr(space + 1);
        if (column.size() > 3 ||
            column.find_first_not_of("0123456789") != std::string::npos ||
            std::stoul(column) < 2)
          reject("the column of the height is a number from 2 on, not \"" +
                 quotable(column) + "\".");
        return {trimmed(rest.substr(0, space)), std::stoul(column)};
      }

      void read(const std::size_t column);

      const std::string     entry, text;
      std::filesystem::path path;
    };

    void RecordFile::read(const std::size_t column)
    {
      const std::string problem = why_unreadable(path);
      if (!problem.empty())
        reject("cannot be read: " + problem + ".");
      if (size_of(path) > most_bytes)
        reject("it has " + human_bytes(static_cast<double>(size_of(path))) +
               "; at most " + human_bytes(most_bytes) + " are read.");
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
                          " m about the mean is that of no surface a wheel "
                          "rolls on (at most 5e-3 m)." +
                          hint,
                        file.lines[k]);
          if (k == 0)
            continue;
          const double slope =
            units.height * (file.heights[k] - file.heights[k - 1]) /
            (units.position * (file.positions[k] - file.positions[k - 1]));
          if (std::abs(slope) > steepest_surface)
            file.reject("a slope of " + significant(slope, 3) +
                          " is that of no surface a wheel rolls on (at most "
                          "0.1)." +
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
  } // namespace

  bool names_a_record(const std::string &text)
  {
    return text.compare(0, keyword.size(), keyword) == 0 ||
           boost::ends_with(text, ".csv");
  }

  SurfaceRecord read_surface_record(const std::string           &entry,
                                    const std::string           &text,
                                    const std::filesystem::path &folder,
                                    const RecordUnits           &units)
  {
    const RecordFile file(entry, text, folder);
    check_gaps(file, units.position);
    SurfaceRecord record;
    record.entry = entry;
    record.file  = file.file().string();
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

  std::string SurfaceRecord::fingerprint() const
  {
    boost::crc_32_type crc;
    for (const double height : heights)
      crc.process_bytes(&height, sizeof(height));
    return std::to_string(heights.size()) + " heights from " +
           significant(begin, 9) + " to " + significant(end(), 9) +
           " m, CRC-32 " + std::to_string(crc.checksum());
  }
} // namespace RollingContact
