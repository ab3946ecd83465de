#ifndef rolling_contact_surfaces_contact_search_h
#define rolling_contact_surfaces_contact_search_h

#include <rolling_contact/surfaces/height_bounds.h>

#include <array>
#include <optional>
#include <utility>

namespace RollingContact::Profiles
{
  /**
   * Where the wheelset is, from its centre in the track at z = - wheel radius:
   * turned by Rx(roll) Rz(yaw) and shifted, in a frame with x forwards, y to
   * the right and z down. Units: m, rad.
   */
  struct WheelsetPosition
  {
    double shift = 0.;
    double roll  = 0.;
    double yaw   = 0.;
  };

  /**
   * The first point in which rigid surfaces touch. Units: m, rad, 1/m.
   */
  struct RigidContact
  {
    double height;          ///< of the wheelset, z, when they touch
    double x, y, z;         ///< in the track
    double y_wheel;         ///< on the wheel's profile
    double y_rail;          ///< from the rail's highest point
    double angle;           ///< of the tangent plane about x
    double rolling_radius;  ///< of the wheel there
    double wheel_curvature; ///< across, positive if convex
    double rail_curvature;  ///< across, positive if convex
  };

  /**
   * The wheel and the rail of the right-hand side. Exact for rails that are
   * straight and for any roll and yaw: a rail touches the wheel only where the
   * wheel's normal has no component along it, on the circle at y_w at the angle
   *
   *   sin theta = - tan(yaw) r'(y_w),
   *
   * and the points there are a plane curve (Y, Z)(y_w), the silhouette. Its gap
   * to the rail is z_rail(Y) - Z. Units: m, rad.
   */
  class WheelOnRail
  {
  public:
    /**
     * @p wheel over the tape circle, at which its radius is @p radius and which
     * is @p tape_circle from the middle of the wheelset; @p rail in its place
     * in the track.
     */
    WheelOnRail(const ProfileCurve &wheel,
                const ProfileCurve &rail,
                const double        radius,
                const double        tape_circle);

    WheelOnRail(const WheelOnRail &)            = delete;
    WheelOnRail &operator=(const WheelOnRail &) = delete;

    /**
     * The first contact of a wheelset that comes down at this shift, roll and
     * yaw. Throws InputError if the wheel is not above the rail.
     */
    RigidContact first_contact(const WheelsetPosition &position) const;

    /**
     * What is at a place of the wheel's profile (arc length) and on the rail
     * below it when the wheelset is at the height at which it touches first.
     */
    RigidContact at(const WheelsetPosition &position,
                    const double            arc_length,
                    const double            height) const;

    /**
     * The gap between the silhouette at a place on the wheel's profile (arc
     * length) and the rail, for a wheelset of height 0; nothing beside the
     * rail.
     */
    std::optional<double> gap(const WheelsetPosition &position,
                              const double            arc_length) const;

    /**
     * The wheel's section through its axle, y and z of a place on the profile
     * (arc length) in the track, for a wheelset of height 0.
     */
    std::pair<double, double> section(const WheelsetPosition &position,
                                      const double            arc_length) const;

    const ProfileCurve &wheel_profile() const
    {
      return wheel;
    }

    const ProfileCurve &rail_profile() const
    {
      return rail;
    }

    /**
     * At the tape circle.
     */
    double wheel_radius() const
    {
      return radius;
    }

    /**
     * Distance of the tape circle from the middle of the wheelset.
     */
    double tape_circle_place() const
    {
      return tape_circle;
    }

  private:
    struct Point
    {
      double x, y, z;
    };

    Point silhouette(const WheelsetPosition &position,
                     const double            arc_length) const
    {
      return silhouette(position, wheel.at(arc_length));
    }

    Point silhouette(const WheelsetPosition &position,
                     const CurvePoint       &at) const;

    /**
     * Gaps at the places that the search steps through, as far as they may be
     * near the least one, and one further to both sides; the largest number
     * elsewhere and beside the rail.
     */
    std::vector<double> low_gaps(const WheelsetPosition &position) const;

    ProfileCurve            wheel, rail;
    double                  radius, tape_circle;
    ArcLengthAtY            rail_at;
    HeightBounds            rail_heights;
    double                  rail_top; ///< arc length
    std::vector<CurvePoint> steps;    ///< on the wheel
  };

  /**
   * Across, where a rail is @p gauge_height below its highest point on the
   * gauge side; nothing if it does not reach down to there. Units: m.
   */
  std::optional<double> y_of_gauge_face(const ProfileCurve &rail,
                                        const double        gauge_height);

  /**
   * Turn a rail's section inwards by atan(@p inclination) and put it where its
   * highest point has z = 0 and its gauge face is @p gauge / 2 from the middle
   * of the track, see y_of_gauge_face(). Throws InputError if there is none.
   * Units: m, 1.
   */
  ProfileCurve placed_rail(const ProfileCurve &section,
                           const double        inclination,
                           const double        gauge,
                           const double        gauge_height);

  /**
   * The wheel and the rail of the left-hand side, mirrored, as those of the
   * right-hand side are seen for this position.
   */
  WheelsetPosition mirrored(const WheelsetPosition &position);

  /**
   * The roll at which both sides touch at one height, the left one given as a
   * right-hand one, at a shift against each of the rails, right and left.
   * Throws InputError if there is none within 0.05 rad. Units: m, rad.
   */
  double resting_roll(const WheelOnRail           &right,
                      const WheelOnRail           &left,
                      const std::array<double, 2> &shifts,
                      const double                 yaw);

  inline double resting_roll(const WheelOnRail &right,
                             const WheelOnRail &left,
                             const double       shift,
                             const double       yaw)
  {
    return resting_roll(right,
                        left,
                        std::array<double, 2>{{shift, shift}},
                        yaw);
  }
} // namespace RollingContact::Profiles

#endif
