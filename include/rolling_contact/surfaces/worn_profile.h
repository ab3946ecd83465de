#ifndef rolling_contact_surfaces_worn_profile_h
#define rolling_contact_surfaces_worn_profile_h

#include <rolling_contact/surfaces/profile_file.h>

#include <vector>

namespace RollingContact::Profiles
{
  /**
   * A curve with points at most @p spacing apart along it, those it had before
   * among them: further ones on its cubics, with their tangents. From points
   * 0.2 mm apart of S1002 it is off by 1e-13 m. Throws
   * std::invalid_argument for a spacing that is not positive. Units: m.
   */
  ProfileCurve subdivided(const ProfileCurve &curve, const double spacing);

  /**
   * The curve moved into the body by a distance h at each of its points, with
   * tangents that follow from it:
   *
   *   r + m h n,   angle + atan2(m h', 1 - m kappa h),
   *
   * n the normal downwards from the curve, m = 1 on a rail and -1 on a wheel,
   * h' and kappa by differences over the points. Points where h and h' are 0
   * stay to the bit. Throws InputError, naming the place, if h reaches the
   * radius of curvature, so that points would run backwards, and
   * std::invalid_argument unless there is a finite distance for each point.
   * Units: m.
   */
  ProfileCurve offset_into_body(const ProfileCurve        &curve,
                                const ProfileKind          kind,
                                const std::vector<double> &distances);

  /**
   * The profile without what has worn: the area between both curves, see
   * worn_area(), is the sum of the amounts to 1e-9 of it. The distance h along
   * the normal at a point is that of a layer which holds the depth a per length
   * of the curve before wear,
   *
   *   h - m kappa h^2 / 2 = a,
   *
   * with kappa averaged as smoothed() does by 1 mm, and all distances are
   * scaled by what is left of the difference of the sums. Without wear it is
   * the same curve to the bit. Throws InputError, naming the place, where
   * offset_into_body() does, if more than a thousandth of the largest depth is
   * at an end, beyond which the body is not known, and if the curve crosses
   * itself or the flank of a flange is behind the first point of the profile:
   * it is worn through to its back. Units: m^2.
   */
  ProfileCurve worn(const ProfileCurve        &curve,
                    const ProfileKind          kind,
                    const std::vector<double> &amounts);
} // namespace RollingContact::Profiles

#endif
