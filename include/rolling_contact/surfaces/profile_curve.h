#ifndef rolling_contact_surfaces_profile_curve_h
#define rolling_contact_surfaces_profile_curve_h

#include <array>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * A point of a profile: coordinates across the track and downwards, and the
   * angle of the tangent, dz/dy = tan(angle). Units: m, rad.
   */
  struct CurvePoint
  {
    double y, z, angle;
  };

  /**
   * The section of a wheel's or a rail's running surface as a curve (y, z)(s)
   * of the arc length, from the gauge side to the field side of the right-hand
   * side: y towards the field side, z down. Between its points it is the cubic
   * with their coordinates and tangents, so that curvature may jump at them.
   * Units: m.
   */
  class ProfileCurve
  {
  public:
    /**
     * Throws std::invalid_argument unless there are two points or more, none
     * twice in a row.
     */
    explicit ProfileCurve(std::vector<CurvePoint> points);

    double length() const
    {
      return arc.back();
    }

    const std::vector<CurvePoint> &points() const
    {
      return nodes;
    }

    /**
     * The arc length at each of the points.
     */
    const std::vector<double> &arc_lengths() const
    {
      return arc;
    }

    /**
     * The point at an arc length between 0 and length().
     */
    CurvePoint at(const double s) const;

    /**
     * d angle / ds there, positive where the curve turns downwards on its way
     * to the field side: on a rail's head and in a wheel's flange root, not at
     * the tip of the flange. Units: m, 1/m.
     */
    double curvature(const double s) const;

    /**
     * Turned by an angle from y towards z about the origin. Units: rad.
     */
    ProfileCurve turned(const double angle) const;

    /**
     * Moved by these distances. Units: m.
     */
    ProfileCurve shifted(const double dy, const double dz) const;

    /**
     * The highest point, least z, as an arc length.
     */
    double highest() const;

    /** Coordinates and their derivatives by the arc length. */
    struct Derivatives
    {
      double y, z, dy, dz, ddy, ddz;
    };

    /** At an arc length between 0 and length(). */
    Derivatives derivatives(const double s) const;

  private:
    std::vector<CurvePoint>            nodes;
    std::vector<std::array<double, 2>> tangents; ///< at the nodes
    std::vector<double>                arc;
  };

  /**
   * The arc length at which the curve reaches a coordinate y, on the part of it
   * around its highest point where y increases. Does not own the curve. Units:
   * m.
   */
  class ArcLengthAtY
  {
  public:
    explicit ArcLengthAtY(const ProfileCurve &curve);

    /** Whether the curve reaches this y. */
    bool covers(const double y) const
    {
      return y >= y_of_nodes.front() && y <= y_of_nodes.back();
    }

    /** For a y that it covers. */
    double operator()(const double y) const;

    /** The points of the curve on that part: the first of them, their number.
     */
    std::size_t first_point() const
    {
      return first;
    }

    std::size_t n_points() const
    {
      return y_of_nodes.size();
    }

  private:
    const ProfileCurve *curve;
    std::size_t         first; ///< node of the curve
    std::vector<double> y_of_nodes;
  };
} // namespace RollingContact::Profiles

#endif
