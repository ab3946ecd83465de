#ifndef rolling_contact_surfaces_wear_deposit_h
#define rolling_contact_surfaces_wear_deposit_h

#include <rolling_contact/surfaces/profile_curve.h>

#include <vector>

namespace RollingContact::Profiles
{
  /**
   * The arc length at which the profile reaches a coordinate y, see
   * ArcLengthAtY; beyond the part that does, as if the profile went on level.
   * On a steep flank an error of y is one of y / cos(angle) along it. Units: m.
   */
  double arc_length_across(const ProfileCurve &curve, const double y);

  /**
   * A line of nodes along the direction of rolling that wears a strip of a
   * profile: the place of its middle along the curve before wear, which may lie
   * beyond an end, the width of the strip along the curve, and the depth along
   * the normal. Its amount is depth times width. Units: m.
   */
  struct WearLine
  {
    double s, width, depth;
  };

  /**
   * What lines wear at the points of a profile, amounts of area whose sum is
   * that of the lines, sum_k A_k = sum_i depth_i width_i, as is their first
   * moment unless a line reaches beyond an end. The amount of a line is spread
   * as a hat that falls to 0 at the lines next to it; where there is none
   * within three widths, so that its height is the depth. The points have
   *
   *   A_k = integral a(s) psi_k(s) ds
   *
   * exactly, a the sum of the hats and psi_k the hat function of point k. What
   * lies beyond an end goes to the point there. Lines of one state, in any
   * order; amounts of several states on the same curve may be added. Depths
   * below 0, as extrapolated ones have, add material. Throws
   * std::invalid_argument if a line is not finite or its width not positive.
   * Units: m^2.
   */
  std::vector<double> deposited(const ProfileCurve   &curve,
                                std::vector<WearLine> lines);

  /**
   * Amounts at the points of a profile, spread with a triangular kernel which
   * is 1/width high and reaches to @p width on both sides, narrower next to the
   * ends: sum and first moment are kept, constant depths too, and a width of 0
   * changes nothing. Depths that are linear between points @p width apart
   * become cubic B-splines, with continuous curvature. Units: m, m^2.
   */
  std::vector<double> smoothed(const ProfileCurve        &curve,
                               const std::vector<double> &amounts,
                               const double               width);

  /**
   * The depth at each point that amounts are, area over length of the curve
   * before wear. Units: m.
   */
  std::vector<double> depths_of(const ProfileCurve        &curve,
                                const std::vector<double> &amounts);

  /**
   * Throws std::invalid_argument unless there is a finite value for each point
   * of the curve.
   */
  void check_number_of_points(const ProfileCurve        &curve,
                              const std::vector<double> &values);
} // namespace RollingContact::Profiles

#endif
