#ifndef rolling_contact_mesh_zone_box_h
#define rolling_contact_mesh_zone_box_h

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace RollingContact
{
  /**
   * A rectangle of the plane of contact: a part of a patch, or of the zone of
   * nodes that may touch. Units: m.
   */
  struct ZoneBox
  {
    std::array<double, 2> lower, upper;

    bool contains(const double x, const double y) const
    {
      return lower[0] <= x && x <= upper[0] && lower[1] <= y && y <= upper[1];
    }

    /**
     * With distances added on all sides.
     */
    ZoneBox grown(const double in_x, const double in_y) const
    {
      return {{{lower[0] - in_x, lower[1] - in_y}},
              {{upper[0] + in_x, upper[1] + in_y}}};
    }
  };

  /**
   * Whether each of equal parts of a @p box, of at most @p step, has its middle
   * in one of several @p boxes. Units: m.
   */
  inline bool covers(const std::vector<ZoneBox> &boxes,
                     const ZoneBox              &box,
                     const double                step)
  {
    const auto number = [&](const unsigned int d) {
      return std::ceil((box.upper[d] - box.lower[d]) / step);
    };
    const auto place = [&](const unsigned int d, const double k) {
      return box.lower[d] +
             (k + 0.5) / number(d) * (box.upper[d] - box.lower[d]);
    };
    for (double i = 0.; i < number(0); ++i)
      for (double j = 0.; j < number(1); ++j)
        {
          const double x = place(0, i), y = place(1, j);
          if (std::none_of(boxes.begin(), boxes.end(), [&](const auto &other) {
                return other.contains(x, y);
              }))
            return false;
        }
    return true;
  }
} // namespace RollingContact

#endif
