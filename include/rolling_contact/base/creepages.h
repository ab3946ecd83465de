#ifndef rolling_contact_base_creepages_h
#define rolling_contact_base_creepages_h

#include <array>

namespace RollingContact
{
  /**
   * Rigid slip of the wheel over the rail, over the rolling speed:
   * (x - spin Y, y + spin X) at the point (X, Y). Units: 1, 1, 1/m.
   */
  struct Creepages
  {
    double x    = 0.;
    double y    = 0.;
    double spin = 0.;

    /**
     * Rigid slip at the point (X, Y), in m. Units: 1.
     */
    std::array<double, 2> at(const std::array<double, 2> &point) const
    {
      return {{x - spin * point[1], y + spin * point[0]}};
    }

    friend bool operator==(const Creepages &one, const Creepages &other)
    {
      return one.x == other.x && one.y == other.y && one.spin == other.spin;
    }
  };
} // namespace RollingContact

#endif
