#ifndef rolling_contact_mesh_running_surfaces_h
#define rolling_contact_mesh_running_surfaces_h

#include <rolling_contact/mesh/placed_profile.h>

namespace RollingContact
{
  /**
   * The running surface of a rail with this head, down to the lower corners of
   * a 60E1's head, whose sides it follows beyond the ends of the profile.
   * Throws InputError if the profile is too far from such a head. Units: m.
   */
  RunningSurface rail_surface(const PlacedProfile &placed);

  /**
   * Where a wheel's profile is on the back side of the tip of its flange, as an
   * arc length: there the running surface begins. Units: m.
   */
  double flange_tip(const Profiles::ProfileCurve &profile);

  /**
   * The running surface of a wheel from the tip of its flange to the chamfer.
   * Throws InputError if the profile does not reach over the tip. Units: m.
   */
  RunningSurface wheel_surface(const PlacedProfile &placed);
} // namespace RollingContact

#endif
