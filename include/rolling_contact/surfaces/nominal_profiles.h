#ifndef rolling_contact_surfaces_nominal_profiles_h
#define rolling_contact_surfaces_nominal_profiles_h

#include <rolling_contact/surfaces/profile_curve.h>

#include <string>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * The wheel profile S1002 of EN 13715 (UIC 510-2): polynomials and arcs, z
   * over the tape circle at y = 0, from the flange's back at y = -70 mm to y =
   * 60 mm. Units: m.
   */
  ProfileCurve s1002();

  /**
   * The names of rails that rail_head() knows: of EN 13674-1, and "60E1
   * Manchester", the variant of 60E1 in the Manchester benchmarks, with joints
   * at |y| = 10.50058 and 25.98807 mm: 0.023 mm from the one of the standard.
   */
  std::vector<std::string> rail_names();

  /**
   * The head of the rail of this name, not inclined, origin on the crown: arcs
   * that are tangent to each other, and sides down to z = 40 mm, which is below
   * the lower corners of the head. The width where the last arc ends is that of
   * the standard to 0.4 um. Throws std::invalid_argument for another name.
   * Units: m.
   */
  ProfileCurve rail_head(const std::string &name);
} // namespace RollingContact::Profiles

#endif
