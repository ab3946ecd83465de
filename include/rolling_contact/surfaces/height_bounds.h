#ifndef rolling_contact_surfaces_height_bounds_h
#define rolling_contact_surfaces_height_bounds_h

#include <rolling_contact/surfaces/profile_curve.h>

#include <utility>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * Between which heights a curve is at a coordinate y, on the part of it
   * around its highest point where y increases: by the chord of its two points
   * there and by how far the cubic leaves it, some ten times as fast as the
   * curve itself. Units: m.
   */
  class HeightBounds
  {
  public:
    explicit HeightBounds(const ProfileCurve &curve);

    /** Least and largest z at a y that the curve covers. */
    std::pair<double, double> operator()(const double y) const;

  private:
    struct Chord
    {
      double y, z, slope, off;
    };

    std::vector<double> ends; ///< y of points
    std::vector<Chord>  chords;
  };
} // namespace RollingContact::Profiles

#endif
