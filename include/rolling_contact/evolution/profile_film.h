#ifndef rolling_contact_evolution_profile_film_h
#define rolling_contact_evolution_profile_film_h

#include <rolling_contact/surfaces/profile_curve.h>

#include <string>

namespace RollingContact
{
  /**
   * A strip of a running surface, 40 mm along the track, as a VTU file with
   * `wear`, by which each point of the material was moved from @p before to
   * @p now, and `depth`, its length. The curves are those of a right-hand side,
   * with y = 0 so far from the middle of the track as @p middle tells; @p side:
   * 1, or -1 for the left-hand side, which is their mirror image. Points are x
   * along the track, y to the right from its middle, z upwards. Units: m.
   */
  std::string worn_strip(const Profiles::ProfileCurve &before,
                         const Profiles::ProfileCurve &now,
                         const double                  middle,
                         const double                  side);
} // namespace RollingContact

#endif
