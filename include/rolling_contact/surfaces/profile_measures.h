#ifndef rolling_contact_surfaces_profile_measures_h
#define rolling_contact_surfaces_profile_measures_h

#include <rolling_contact/surfaces/profile_file.h>

#include <optional>

namespace RollingContact::Profiles
{
  /**
   * What a wheel's flange is measured by: the height Sh of its tip over the
   * tread at the tape circle y = 0, the thickness Sd from its back to the
   * flank 10 mm below that tread, and qR, how far across the flank goes from 2
   * mm above the lowest point of the tip to that place. After EN 13715 and EN
   * 15313, unverified: levels and names are recalled, not read in the
   * standards. Units: m.
   */
  struct FlangeMeasures
  {
    double height;    ///< Sh
    double thickness; ///< Sd
    double qr;        ///< qR
  };

  /**
   * The measures of a wheel's profile over its tape circle, z down, worn or
   * not; nothing if it has no flange 12 mm high with its tip and its flank, or
   * does not reach the tape circle. The back of the flange is the least y of
   * the profile if that begins on it, steeper than 80 degrees, else the plane
   * y = @p flange_back. Of S1002: 28.00, 32.50 and 10.79 mm. Units: m.
   */
  std::optional<FlangeMeasures>
  flange_measures(const ProfileCurve &wheel, const double flange_back = -0.07);

  /**
   * The area between a profile and that of the same body when it has worn, with
   * straight lines between their ends; negative where material was added. From
   *
   *   1/2 integral (y dz - z dy),
   *
   * exactly for the cubics. Units: m^2.
   */
  double worn_area(const ProfileCurve &before,
                   const ProfileCurve &after,
                   const ProfileKind   kind);

  /**
   * A depth and where on the curve before wear it is, as an arc length. Units:
   * m.
   */
  struct WornDepth
  {
    double depth, s;
  };

  /**
   * The largest distance from the points of a curve, along its normal there
   * into the body, to the next point of another one; 0 at s = 0 if that lies
   * nowhere deeper. Points from which it is not met, as at ends, are left out.
   * For a curve of points elsewhere, 0.1 mm apart on an arc of 13 mm, within
   * 1e-10 m.
   * Units: m.
   */
  WornDepth largest_worn_depth(const ProfileCurve &before,
                               const ProfileCurve &after,
                               const ProfileKind   kind);
} // namespace RollingContact::Profiles

#endif
