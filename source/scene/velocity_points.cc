#include <deal.II/base/utilities.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/velocity_points.h>

#include <algorithm>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::string letters  = "abcdefghijklmnopqrstuvwxyz"
                                 "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const std::string in_names = letters + "0123456789_-";

    /** What a point of a body is given by, with an example. */
    std::string form_of(const std::string &section)
    {
      return section == "Wheel"
               ? "name: radius in m, angle from the contact in degrees, "
                 "position along the axle in m; several are separated by "
                 "semicolons, such as \"tread: 0.46, 90, 0; web: 0.3, 0, 0.01\""
               : "name: x, y, z in m from the contact point; several are "
                 "separated by semicolons, such as \"foot: 0.3, 0, -0.17\"";
    }

    VelocityPoint read_point(const std::string &section,
                             const std::string &text,
                             const unsigned int dimension)
    {
      const auto fail = [&](const std::string &what) {
        throw InputError(section + "/Velocity points: \"" + quotable(text) +
                         "\" " + what + "; give " + form_of(section) + ".");
      };
      const auto parts = Utilities::split_string_list(text, ':');
      if (parts.size() != 2 || parts[0].empty())
        fail("is not a named point");
      VelocityPoint point{parts[0], {}};
      if (letters.find(point.name[0]) == std::string::npos ||
          point.name.find_first_not_of(in_names) != std::string::npos)
        fail("has a name that cannot name a column: it must begin with a "
             "letter and have only letters, digits, _ and -");
      const auto words = Utilities::split_string_list(parts[1], ',');
      if (words.size() != 3)
        fail("needs three numbers, and has " + std::to_string(words.size()));
      for (unsigned int d = 0; d < 3; ++d)
        {
          const auto value = number(words[d]);
          if (!value)
            fail("has no number in \"" + words[d] + "\"");
          point.place[d] = *value;
        }
      const unsigned int across = section == "Wheel" ? 2 : 1;
      if (dimension == 2 && point.place[across] != 0.)
        fail("is not in the plane: in 2D its " +
             std::string(across == 2 ? "third" : "second") + " number is 0");
      if (section == "Wheel" && point.place[0] < 0.)
        fail("has a radius below 0 m");
      return point;
    }
  } // namespace

  std::vector<VelocityPoint> read_velocity_points(const std::string &section,
                                                  const std::string &text,
                                                  const unsigned int dimension)
  {
    std::vector<VelocityPoint> points;
    for (const std::string &part : Utilities::split_string_list(text, ';'))
      {
        if (part.empty())
          continue;
        const VelocityPoint point = read_point(section, part, dimension);
        if (std::any_of(points.begin(), points.end(), [&](const auto &other) {
              return other.name == point.name;
            }))
          throw InputError(section +
                           "/Velocity points: there is more than one "
                           "point with the name " +
                           point.name +
                           "; each has a column of its own, give "
                           "them different names.");
        points.push_back(point);
      }
    return points;
  }

  std::string velocity_column(const std::string &point, const char axis)
  {
    return "velocity_" + point + '_' + axis + "_m/s";
  }
} // namespace RollingContact
