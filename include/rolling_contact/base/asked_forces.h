#ifndef rolling_contact_base_asked_forces_h
#define rolling_contact_base_asked_forces_h

#include <optional>

namespace RollingContact
{
  /**
   * Forces on the wheel and moment about the origin of the contact plane that
   * are given in place of the creepages along x, along y and of the spin; empty
   * where the creepage is given. Units: N, N, N m.
   */
  struct AskedForces
  {
    std::optional<double> x, y, moment;

    bool any() const
    {
      return x || y || moment;
    }
  };
} // namespace RollingContact

#endif
