#ifndef rolling_contact_surfaces_profile_doubts_h
#define rolling_contact_surfaces_profile_doubts_h

#include <rolling_contact/surfaces/profile_file.h>

#include <string>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * Warnings about measured points that are allowed but probably wrong, a
   * sentence each: a profile much too narrow for a wheel or the head of a rail
   * (another unit, or exchanged columns); a wheel whose flange is not at its
   * usual distance from a tape circle at y = 0; stretches without points, which
   * the smoothing spline of profile_of_points() bridges; points that scatter by
   * 12 um or more; a grooved rail, whose keeper is left out. The points are in
   * the order of the file, mirrored as its entry says, in m. Messages call the
   * profile @p name.
   */
  std::vector<std::string>
  doubts_of_points(const std::vector<MeasuredPoint> &points,
                   const ProfileKind                 kind,
                   const std::string                &name);
} // namespace RollingContact::Profiles

#endif
