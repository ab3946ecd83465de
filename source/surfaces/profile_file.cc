#include <boost/algorithm/string.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/text_table.h>
#include <rolling_contact/surfaces/profile_file.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace RollingContact::Profiles
{
  namespace
  {
    const std::size_t least_points = 10;

    const std::size_t most_bytes = 20'000'000;

    std::string at_line(const std::filesystem::path &file,
                        const std::size_t            line)
    {
      return file.string() + ", line " + std::to_string(line) + ": ";
    }

    /**
     * The numbers of a line; nothing if it holds anything else. Throws
     * InputError if they have decimal commas.
     */
    std::optional<std::vector<double>>
    numbers(const std::string           &line,
            const std::filesystem::path &file,
            const std::size_t            line_number)
    {
      const std::string cure = cure_of_decimal_commas(line);
      if (!cure.empty() && line.find_first_of("; \t") != std::string::npos)
        throw InputError(at_line(file, line_number) + "\"" + quotable(line) +
                         "\" has decimal commas" + cure + ".");
      std::string blank = line;
      for (char &c : blank)
        if (c == ',' || c == ';')
          c = ' ';
      std::vector<double> found;
      for (const std::string &word : cells_of(blank))
        if (const auto value = number(word))
          found.push_back(*value);
        else
          return {};
      return found;
    }

    TextLines lines_of(const std::filesystem::path &file,
                       const char                  *comment_marks)
    {
      const std::string why = why_unreadable(file);
      if (!why.empty())
        throw InputError(file.string() + ": " + why + ".");
      if (size_of(file) > most_bytes)
        throw InputError(file.string() + ": " +
                         human_bytes(static_cast<double>(size_of(file))) +
                         " are too many for a profile; at most " +
                         human_bytes(most_bytes) + " are read.");
      return TextLines(file, comment_marks);
    }

    /** A line of names, as "y;z" or "y [mm], z [mm]". */
    bool is_heading(const std::string &line)
    {
      return line.find_first_of("0123456789") == std::string::npos;
    }

  } // namespace

  ProfileFormat format_of(const std::filesystem::path &file)
  {
    const std::string ending = boost::to_lower_copy(file.extension().string());
    if (ending == ".prr" || ending == ".prw")
      return ProfileFormat::simpack;
    if (ending == ".ban" || ending == ".whl")
      return ProfileFormat::miniprof;
    return ProfileFormat::columns;
  }

  std::vector<std::array<double, 2>>
  read_columns(const std::filesystem::path &file, const std::string &columns)
  {
    std::vector<std::array<double, 2>> rows;
    TextLines                          lines       = lines_of(file, "#%!");
    bool                               has_heading = false;
    while (lines.next())
      {
        if (rows.empty() && !has_heading && is_heading(lines.text))
          {
            has_heading = true;
            continue;
          }
        const auto found = numbers(lines.text, file, lines.number);
        if (!found || found->size() != 2)
          throw InputError(at_line(file, lines.number) + "\"" +
                           quotable(lines.text) + "\" is not two numbers, " +
                           columns +
                           ", with decimal points, separated by blanks, a "
                           "comma, a semicolon or a tab; # begins a comment.");
        rows.push_back({{(*found)[0], (*found)[1]}});
      }
    return rows;
  }

  namespace
  {
    /**
     * The keys of a SIMPACK file and the points between point.begin and
     * point.end.
     */
    class SimpackFile
    {
    public:
      explicit SimpackFile(const std::filesystem::path &file)
        : file(file)
      {
        bool      in_points = false;
        TextLines lines     = lines_of(file, "!");
        while (lines.next())
          {
            const std::string &text = lines.text;
            if (boost::starts_with(text, "point.begin"))
              in_points = true;
            else if (boost::starts_with(text, "point.end"))
              in_points = false;
            else if (in_points)
              add_point(text, lines.number);
            else if (const auto equals = text.find('=');
                     equals != std::string::npos)
              keys[trimmed(text.substr(0, equals))] =
                trimmed(text.substr(equals + 1));
          }
      }

      /** Scaled, mirrored, in the other order, shifted, turned, cut. */
      std::vector<MeasuredPoint> points() const
      {
        const double unit = 1 / value("units.len.f", 1000.);
        if (!(unit > 0.) || !std::isfinite(unit))
          throw InputError(file.string() + ": units.len.f must be above 0.");
        const double angle = value("rotate", 0.) / value("units.ang.f", 1.);
        std::vector<MeasuredPoint> found;
        for (MeasuredPoint point : raw)
          {
            if (value("mirror.y", 0.) != 0.)
              point.y = -point.y;
            if (value("mirror.z", 0.) != 0.)
              point.z = -point.z;
            point.y += value("shift.y", 0.);
            point.z += value("shift.z", 0.);
            point = {std::cos(angle) * point.y - std::sin(angle) * point.z,
                     std::sin(angle) * point.y + std::cos(angle) * point.z};
            if (inside("y", point.y) && inside("z", point.z))
              found.push_back({unit * point.y, unit * point.z});
          }
        if (value("inversion", 0.) != 0.)
          std::reverse(found.begin(), found.end());
        return found;
      }

    private:
      void add_point(const std::string &text, const std::size_t line)
      {
        const auto found = numbers(text, file, line);
        if (!found || found->size() < 2)
          throw InputError(at_line(file, line) + "\"" + quotable(text) +
                           "\" is not a point: y, z and perhaps a weight.");
        raw.push_back({(*found)[0], (*found)[1]});
      }

      double value(const std::string &key, const double otherwise) const
      {
        const auto found = keys.find(key);
        if (found == keys.end() || found->second.empty())
          return otherwise;
        const auto read = number(found->second);
        if (!read)
          throw InputError(file.string() + ": " + key + " = " +
                           quotable(found->second) + " is not a number.");
        return *read;
      }

      /** Bounds of 0, 0 are none. */
      bool inside(const std::string &axis, const double coordinate) const
      {
        const double least = value("bound." + axis + ".min", 0.),
                     most  = value("bound." + axis + ".max", 0.);
        return !(least < most) || (coordinate >= least && coordinate <= most);
      }

      const std::filesystem::path        file;
      std::map<std::string, std::string> keys;
      std::vector<MeasuredPoint>         raw;
    };

    /**
     * Lines of a key and a value, then two or three columns of numbers; y and z
     * point the other way than here.
     */
    std::vector<MeasuredPoint> read_miniprof(const std::filesystem::path &file,
                                             const double                 unit)
    {
      std::vector<MeasuredPoint> points;
      TextLines                  lines = lines_of(file, "");
      while (lines.next())
        {
          std::string text = lines.text;
          boost::erase_all(text, "\"");
          const auto found = numbers(text, file, lines.number);
          if (found && found->size() >= 2)
            points.push_back({-unit * (*found)[0], -unit * (*found)[1]});
          else if (!points.empty() && !text.empty())
            throw InputError(
              at_line(file, lines.number) + "\"" + quotable(text) +
              "\" among the points is not a point: give two or three "
              "numbers.");
        }
      return points;
    }
  } // namespace

  std::vector<MeasuredPoint> read_points(const std::filesystem::path &file,
                                         const FileOptions           &options)
  {
    std::vector<MeasuredPoint> points;
    switch (format_of(file))
      {
        case ProfileFormat::columns:
          for (const auto &row : read_columns(file, "y and z"))
            points.push_back({options.unit * row[0], options.unit * row[1]});
          break;
        case ProfileFormat::simpack:
          points = SimpackFile(file).points();
          break;
        case ProfileFormat::miniprof:
          points = read_miniprof(file, options.unit);
          break;
      }
    if (points.size() < least_points)
      throw InputError(file.string() + ": " + std::to_string(points.size()) +
                       " points found; a profile needs " +
                       std::to_string(least_points) + " or more.");
    if (points.size() > most_profile_points)
      throw InputError(file.string() + ": " + std::to_string(points.size()) +
                       " points found; at most " +
                       std::to_string(most_profile_points) +
                       " are taken, a point every 0.02 mm of a profile.");
    for (MeasuredPoint &point : points)
      {
        if (options.mirror_y)
          point.y = -point.y;
        if (options.mirror_z)
          point.z = -point.z;
        point.y += options.shift_y;
      }
    return points;
  }

  ProfileCurve read_profile(const std::filesystem::path &file,
                            const ProfileKind            kind,
                            const FileOptions           &options)
  {
    return profile_of_points(read_points(file, options),
                             kind,
                             options.smoothing_length,
                             file.string());
  }
} // namespace RollingContact::Profiles
