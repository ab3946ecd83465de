#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/hdf5_reader.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/text_table.h>
#include <rolling_contact/surfaces/height_map_file.h>

#include <cmath>
#include <map>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    const double largest_unevenness = 0.01; // of a spacing

    const char missing_mark[] = "BAD";

    std::string times(const double one, const double other)
    {
      return significant(one, 17) + " times " + significant(other, 17);
    }

    void check_size(const SurfaceFile &file,
                    const double       n_x,
                    const double       n_y,
                    const std::size_t  line = 0)
    {
      if (n_x * n_y > most_points_of_map)
        file.reject("it has " + times(n_x, n_y) + " points; at most " +
                      std::to_string(most_points_of_map) +
                      " are read, as they take " +
                      human_bytes(8. * most_points_of_map) +
                      ". Cut the map or leave out points.",
                    line);
    }

    /** A height in m, or not_measured. */
    double height_of(const SurfaceFile &file,
                     const std::string &cell,
                     const double       unit,
                     const std::size_t  line)
    {
      if (cell == missing_mark)
        return not_measured;
      const auto height = number(cell);
      if (!height)
        file.reject("\"" + quotable(cell) +
                      "\" is no finite height; BAD stands where nothing was "
                      "measured" +
                      advice_on_decimals(cell) + ".",
                    line);
      return unit * *height;
    }

    /** The step of places that rise evenly. */
    double spacing_of(const SurfaceFile              &file,
                      const std::vector<double>      &places,
                      const std::vector<std::size_t> &lines,
                      const std::string              &name)
    {
      const double step = (places.back() - places.front()) /
                          (static_cast<double>(places.size()) - 1.);
      for (std::size_t k = 1; k < places.size(); ++k)
        {
          const std::size_t line = lines[std::min(k, lines.size() - 1)];
          if (!(places[k] > places[k - 1]))
            file.reject(name + " does not rise: " + text_of(places[k]) +
                          " follows " + text_of(places[k - 1]) + ".",
                        line);
          if (std::abs(places[k] - places.front() - step * k) >
              largest_unevenness * step)
            file.reject(name + " = " + text_of(places[k]) +
                          " is not where points of equal spacing are, at " +
                          text_of(places.front() + step * k) +
                          " (by 1 % of the spacing): resample the map.",
                        line);
        }
      return step;
    }

    /** Places of the first row and of the first column, and heights by rows. */
    struct TextGrid
    {
      std::vector<double>      y, x, heights;
      std::vector<std::size_t> lines;
      std::size_t              line_of_y = 0;
    };

    double place_of(const SurfaceFile &file,
                    const std::string &cell,
                    const std::string &name,
                    const std::size_t  line)
    {
      const auto found = number(cell);
      if (!found)
        file.reject("\"" + quotable(cell) + "\" is no finite " + name +
                      ": the first row has y, the first column x" +
                      advice_on_decimals(cell) + ".",
                    line);
      return *found;
    }

    TextGrid rows_of(const SurfaceFile &file, const double unit)
    {
      TextGrid                 grid;
      TextLines                text(file.path);
      std::vector<std::string> first;
      while (text.next())
        {
          const auto cells = cells_of(text.text);
          if (first.empty())
            {
              first          = cells;
              grid.line_of_y = text.number;
              continue;
            }
          if (grid.y.empty())
            {
              // what stands over the x is a name or nothing
              const std::size_t corner =
                first.size() == cells.size() || !number(first[0]) ? 1 : 0;
              for (std::size_t k = corner; k < first.size(); ++k)
                grid.y.push_back(place_of(file, first[k], "y", grid.line_of_y));
            }
          if (cells.size() != grid.y.size() + 1)
            file.reject("it has " + std::to_string(cells.size()) +
                          " cells, and x with a height for each y of the first "
                          "row are " +
                          std::to_string(grid.y.size() + 1) + ".",
                        text.number);
          grid.x.push_back(place_of(file, cells[0], "x", text.number));
          grid.lines.push_back(text.number);
          check_size(file, grid.x.size(), grid.y.size(), text.number);
          for (std::size_t k = 1; k < cells.size(); ++k)
            grid.heights.push_back(
              height_of(file, cells[k], unit, text.number));
        }
      return grid;
    }

    MeasuredMap read_grid(const SurfaceFile &file, const RecordUnits &units)
    {
      const TextGrid grid = rows_of(file, units.height);
      MeasuredMap    map;
      map.n_x = grid.x.size();
      map.n_y = grid.y.size();
      if (map.n_x < 2 || map.n_y < 2)
        return map;
      const double unit = units.position;
      map.dx            = unit * spacing_of(file, grid.x, grid.lines, "x");
      map.dy         = unit * spacing_of(file, grid.y, {grid.line_of_y}, "y");
      map.x          = unit * grid.x.front();
      map.y          = unit * grid.y.front();
      map.text_lines = grid.lines;
      map.a_text_line_is_one_x = true;
      map.heights.resize(grid.heights.size());
      for (std::size_t i = 0; i < map.n_x; ++i)
        for (std::size_t j = 0; j < map.n_y; ++j)
          map.heights[j * map.n_x + i] = grid.heights[i * map.n_y + j];
      return map;
    }

    /** Values of the header of an .sdf, which ends with a line of `*`. */
    class SdfHeader
    {
    public:
      SdfHeader(const SurfaceFile &file, TextLines &text);

      /** A number above 0, an integer if it counts. */
      double positive(const std::string &name, const bool counts) const;

    private:
      struct Value
      {
        std::string text;
        std::size_t line;
      };

      const SurfaceFile           &file;
      std::map<std::string, Value> values;
      std::size_t                  end = 0; ///< line
    };

    SdfHeader::SdfHeader(const SurfaceFile &file, TextLines &text)
      : file(file)
    {
      bool ended = false;
      while (!ended && text.next())
        {
          end   = text.number;
          ended = text.text == "*";
          if (ended)
            break;
          const auto equals = text.text.find('=');
          if (equals == std::string::npos)
            file.reject("\"" + quotable(text.text) +
                          "\" is no line of the header, as NumPoints = 512; it "
                          "ends with a line of *.",
                        text.number);
          const std::string name = trimmed(text.text.substr(0, equals));
          const Value value{trimmed(text.text.substr(equals + 1)), text.number};
          if (!values.emplace(name, value).second)
            file.reject(quotable(name) + " is given twice.", text.number);
        }
      if (!ended)
        file.reject("it ends within the header: it is cut off.", text.number);
      for (const std::string name : {"Compression", "CheckType"})
        if (const auto given = values.find(name);
            given != values.end() && number(given->second.text) != 0.)
          file.reject(name + " = " + quotable(given->second.text) +
                        ": only 0 is read, heights as they are.",
                      given->second.line);
    }

    double SdfHeader::positive(const std::string &name, const bool counts) const
    {
      const auto given = values.find(name);
      if (given == values.end())
        file.reject("the header has no " + name + ".", end);
      const auto found = number(given->second.text);
      if (!found || !(*found > 0.) || (counts && *found != std::floor(*found)))
        file.reject(name + " = " + quotable(given->second.text) + ": it is " +
                      (counts ? "a number of points" : "a number above 0") +
                      ".",
                    given->second.line);
      return *found;
    }

    MeasuredMap read_sdf(const SurfaceFile &file)
    {
      TextLines text(file.path, "");
      text.next();
      const std::string kind = text.text.substr(0, 8);
      if (kind == "bISO-1.0" || kind == "bISO-2.0" || kind == "bBCR-1.0")
        file.reject("it is binary; export it as text (aISO-1.0).", 1);
      if (text.text != "aISO-1.0" && text.text != "aISO-2.0" &&
          text.text != "aBCR-1.0")
        file.reject("\"" + quotable(text.text) +
                      "\" is no beginning of a file after ISO 25178-71, which "
                      "is aISO-1.0, aISO-2.0 or aBCR-1.0.",
                    text.number);
      const SdfHeader header(file, text);
      MeasuredMap     map;
      const double    n_x = header.positive("NumPoints", true),
                   n_y    = header.positive("NumProfiles", true),
                   unit   = header.positive("Zscale", false);
      check_size(file, n_x, n_y);
      map.n_x        = static_cast<std::size_t>(n_x);
      map.n_y        = static_cast<std::size_t>(n_y);
      map.dx         = header.positive("Xscale", false);
      map.dy         = header.positive("Yscale", false);
      map.has_places = false;
      while (text.next())
        {
          if (text.text == "*")
            {
              if (map.heights.size() < map.n_x * map.n_y)
                file.reject("there are " + std::to_string(map.heights.size()) +
                              " heights, and NumPoints times NumProfiles are " +
                              times(n_x, n_y) + ".",
                            text.number);
              return map;
            }
          std::istringstream cells(text.text);
          for (std::string cell; cells >> cell;)
            {
              if (map.heights.size() == map.n_x * map.n_y)
                file.reject("there are more heights than NumPoints times "
                            "NumProfiles, " +
                              times(n_x, n_y) + ".",
                            text.number);
              if (map.heights.size() % map.n_x == 0)
                map.text_lines.push_back(text.number);
              map.heights.push_back(height_of(file, cell, unit, text.number));
            }
        }
      file.reject("it ends without a line of * behind its heights, of which "
                  "there are " +
                    std::to_string(map.heights.size()) + " of " +
                    times(n_x, n_y) + ": it is cut off.",
                  text.number);
    }

    MeasuredMap read_hdf5(const SurfaceFile &file, const RecordUnits &units)
    {
      const std::string &dataset = file.source.dataset;
      MeasuredMap        map;
      map.has_places = false;
      try
        {
          const Hdf5Reader reader(file.path);
          const auto       shape = reader.shape(dataset);
          if (shape.size() != 2)
            file.reject(quotable(dataset) + " has " +
                        std::to_string(shape.size()) +
                        " dimensions; a map has two, lines across and points "
                        "along.");
          map.n_y = shape[0];
          map.n_x = shape[1];
          check_size(file, map.n_x, map.n_y);
          for (const auto &[name, spacing] :
               {std::pair("x_spacing", &map.dx), {"y_spacing", &map.dy}})
            {
              *spacing = reader.attribute(dataset, name);
              if (!(*spacing > 0. && std::isfinite(*spacing)))
                file.reject(quotable(dataset) + ": " + name + " = " +
                            text_of(*spacing) + " m: it is above 0.");
            }
          map.heights = reader.numbers(dataset);
        }
      catch (const InputError &error)
        {
          const std::string what = error.what();
          if (what.find(file.entry) == 0)
            throw;
          throw InputError(file.entry + " = " + quotable(file.text, 200) +
                           ": " + what);
        }
      for (double &height : map.heights)
        {
          if (std::isinf(height))
            file.reject(quotable(file.source.dataset) +
                        " has infinite heights; NaN stands where nothing was "
                        "measured.");
          height *= units.height;
        }
      return map;
    }
  } // namespace

  MeasuredMap read_measured_map(const SurfaceFile &file,
                                const RecordUnits &units)
  {
    switch (file.source.kind)
      {
        case SurfaceFile::Kind::grid:
          return read_grid(file, units);
        case SurfaceFile::Kind::sdf:
          return read_sdf(file);
        default:
          return read_hdf5(file, units);
      }
  }
} // namespace RollingContact
