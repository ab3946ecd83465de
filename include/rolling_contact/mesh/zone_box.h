#ifndef rolling_contact_mesh_zone_box_h
#define rolling_contact_mesh_zone_box_h

#include <array>

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
} // namespace RollingContact

#endif
