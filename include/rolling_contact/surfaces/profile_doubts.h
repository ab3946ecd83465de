#ifndef rolling_contact_surfaces_profile_doubts_h
#define rolling_contact_surfaces_profile_doubts_h

#include <rolling_contact/surfaces/profile_file.h>

#include <string>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * What about measured points is allowed but hardly meant, a sentence each for
   * a warning: a profile that is much too narrow for a wheel or the head of a
   * rail (another unit, or its columns exchanged), a wheel whose flange is not
   * where it is from a tape circle at y = 0, stretches without points that the
   * smoothing spline of profile_of_points() bridges by itself, and points that
   * scatter by 12 um or more; of a grooved rail that its keeper is left out.
   * The points are in the order of the file, mirrored as its entry says, in m;
   * @p name is that of messages.
   */
  std::vector<std::string>
  doubts_of_points(const std::vector<MeasuredPoint> &points,
                   const ProfileKind                 kind,
                   const std::string                &name);
} // namespace RollingContact::Profiles

#endif
