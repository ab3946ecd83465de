#ifndef rolling_contact_evolution_profile_film_h
#define rolling_contact_evolution_profile_film_h

#include <rolling_contact/surfaces/profile_curve.h>

#include <string>

namespace RollingContact
{
  /**
   * A strip of a running surface along the track as a VTU file, with `wear`, by
   * which each point of the material was moved from @p before to @p now, and
   * `depth`, its length. The points are x along, y across, z upwards. Units: m.
   */
  std::string worn_strip(const Profiles::ProfileCurve &before,
                         const Profiles::ProfileCurve &now);
} // namespace RollingContact

#endif
