#ifndef rolling_contact_surfaces_contact_frame_h
#define rolling_contact_surfaces_contact_frame_h

#include <rolling_contact/base/creepages.h>
#include <rolling_contact/surfaces/contact_search.h>
#include <rolling_contact/surfaces/wheelset_motion.h>

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace RollingContact::Profiles
{
  /**
   * The surface on which contact is computed: the plane in which wheel and rail
   * touch first, the one at the middle of the patch under load, or the rail's
   * own surface, curved across and straight along. The frame of a plane at the
   * patch is one of kind `plane`.
   */
  enum class SurfaceKind
  {
    plane,
    loaded_plane,
    curved
  };

  /**
   * A line along x of the surface of contact: its place in the plane in which
   * wheel and rail touch first, and its slope against that, downwards towards
   * positive y. Units: m, rad.
   */
  struct SurfacePoint
  {
    double y, z, angle;
  };

  /**
   * The plane in which wheel and rail touch first, turned about x by the angle
   * of the contact, and what the profiles are there. Its origin is the first
   * rigid contact, or the middle of a patch, see at_patch(); x is against the
   * way the wheel rolls forwards, y along the profiles to the right of the
   * vehicle, z out of the rail. A wheel on the left rail is the mirror image of
   * one on the right: y changes its sign.
   *
   * The coordinate s across the surface of contact is y in the plane, or on a
   * curved surface the length along the rail's section from the origin. Units:
   * m, rad.
   */
  class ContactFrame
  {
  public:
    /**
     * Frame of the contact of the right-hand wheel of a wheelset in this @p
     * position, or of the left-hand one. Throws InputError if the wheel is not
     * above the rail.
     */
    ContactFrame(std::shared_ptr<const WheelOnRail> profiles,
                 const WheelsetPosition            &position,
                 const bool                         is_left,
                 const SurfaceKind                  kind = SurfaceKind::plane);

    /**
     * The frame of the same wheelset in the plane at the middle of a patch, at
     * (0, @p s) of this one and turned against it by @p turn, downwards towards
     * positive y. Gaps are 0 where the surfaces touch first, as here. Throws
     * InputError if the wheel does not reach there. Units: m, rad.
     */
    std::shared_ptr<const ContactFrame> at_patch(const double s,
                                                 const double turn) const;

    ContactFrame(const ContactFrame &)            = delete;
    ContactFrame &operator=(const ContactFrame &) = delete;

    /**
     * The origin, as that of a right-hand wheel.
     */
    const RigidContact &origin() const
    {
      return contact;
    }

    /**
     * The contact's angle, slope of the rail towards the right of the vehicle.
     */
    double angle() const;

    /**
     * The contact's place in the track: across, to the right.
     */
    double track_y() const;

    /**
     * The wheel and the rail of the side it is on, as those of a right-hand
     * one.
     */
    const WheelOnRail &wheel_on_rail() const
    {
      return *profiles;
    }

    /**
     * Roll of the wheelset as seen from a right-hand side. Units: rad.
     */
    double roll() const
    {
      return position.roll;
    }

    bool is_left() const
    {
      return sign < 0.;
    }

    SurfaceKind kind() const
    {
      return surface_kind;
    }

    /**
     * Whether the rail reaches to @p s.
     */
    bool covers(const double s) const;

    /**
     * The surface of contact at @p s, which the rail reaches.
     */
    SurfacePoint surface(const double s) const;

    /**
     * Distance of the rigid surfaces along the normal of the surface of contact
     * at (@p x, @p s), 0 where they touch first; nothing where one of them does
     * not reach.
     */
    std::optional<double> gap(const double x, const double s) const;

    /**
     * The rail's arc length at @p s, which it reaches.
     */
    double rail_arc_length(const double s) const;

    /**
     * Where on its profile, as an arc length, the wheel faces the surface of
     * contact at (0, @p s) along the normal; nothing where it does not reach.
     */
    std::optional<double> wheel_arc_length(const double s) const;

    /**
     * Slope of the rail against the surface of contact at @p s, 0 at the
     * origin. Units: rad.
     */
    double rail_angle(const double s) const;

    /**
     * By how much the rail's normal turns from where 5 % of a load lies to the
     * right to where 95 % do; the load as pairs of s and a force (N), against
     * the surface of contact. Units: rad.
     */
    double turn_of_normal(std::vector<std::pair<double, double>> load) const;

    /**
     * What the rigid slip along x at (0, @p s) is beyond that of a spin about
     * the origin, for a wheel that rolls forwards: the radius of the profile r
     * does not change in proportion to the place y in the plane,
     *
     *   (r(y) - r(0)) / r(0) - y dr/dy(0) / r(0);
     *
     * 0 beyond the wheel. Units: 1.
     */
    double slip_beyond_spin(const double s) const;

    /**
     * What the rigid slip across the surface of contact at (@p x, @p s) is
     * beyond that of creepages in the plane, for a wheel that rolls forwards:
     * turning about its axle it comes down ahead of the contact and goes up
     * behind it, which a surface at an angle to the plane feels as slip, x
     * sin(angle) / r. 0 in the plane. Units: 1.
     */
    double slip_of_rolling(const double x, const double s) const;

    /**
     * The spin of a wheel that rolls forwards on a profile inclined like this,
     * -(dr/dy) / r at the origin. Units: 1/m.
     */
    double spin_of_cone() const;

    /**
     * What a motion is over |V|; the axle turns so that there is no
     * longitudinal creepage at the origin if it does not say how.
     */
    GeneralisedVelocities velocities(const WheelsetMotion &motion) const;

    /**
     * The point of the wheel over (@p x, @p s), in the surface of contact
     * beyond the wheel, and what the wheelset's motion does there, along a
     * tangent that is turned by @p angle against the plane, downwards towards
     * positive y. With u the generalised velocities the wheel moves over the
     * rail, which turns below it, with
     *
     *   (u0 - u2 Y, u1 + u2 X, 0) + u3 axle x (P - centre).
     */
    PlaceInTrack
    place_in_track(const double x, const double s, const double angle) const;

    /**
     * Rigid slip of the wheel over the rail at the origin, over |V|.
     */
    Creepages creepages(const WheelsetMotion &motion) const;

    /**
     * A force in this frame in the axes of the track: across, to the right,
     * and upwards. Units: N.
     */
    std::array<double, 2> in_track(const double force_y,
                                   const double force_z) const;

    /**
     * A point of this frame (x = 0) in the track: from its middle to the right,
     * and from the top of the rails upwards.
     */
    std::array<double, 2> point_in_track(const double y, const double z) const;

    /**
     * The point of the rail at @p s as a place in the track; nothing where it
     * does not reach.
     */
    std::optional<std::array<double, 2>> rail_in_track(const double s) const;

    /**
     * The section of the rail as points in the track, as of point_in_track().
     */
    std::vector<std::array<double, 2>> rail_section() const;

    /**
     * The section of the wheel through its axle, when it touches first.
     */
    std::vector<std::array<double, 2>> wheel_section() const;

  private:
    using Vector = std::array<double, 3>;

    /** With this origin of a right-hand wheel, at this @p position of it. */
    ContactFrame(std::shared_ptr<const WheelOnRail> profiles,
                 const WheelsetPosition            &position,
                 const double                       sign,
                 const SurfaceKind                  kind,
                 const RigidContact                &contact);

    /** From axes of the track to those of the wheelset. */
    Vector to_wheelset(const Vector &vector) const;

    /**
     * The rail at @p s as that of a right-hand side, in the frame turned by its
     * contact's angle: y along the plane, z into the rail.
     */
    CurvePoint rail_point(const double s) const;

    /**
     * The surface of contact there; angles are downwards towards positive y.
     */
    CurvePoint surface_point(const double s) const;

    /**
     * The wheel's surface over a point: depth under it along the normal, and
     * where that is on the profile: radius, arc length.
     */
    struct WheelPoint
    {
      double depth, radius, arc_length;
    };

    /** A place of the frame in the track, of a right-hand wheel. */
    Vector in_track_of_right(const double x, const CurvePoint &point) const;

    /**
     * The wheel's surface over (@p x, @p point) as those of a right-hand wheel;
     * nothing where it does not reach.
     */
    std::optional<WheelPoint> wheel_point(const double      x,
                                          const CurvePoint &point) const;

    /**
     * The axle in the axes of the track, the arm from there to the contact, and
     * the velocity of the contact when the wheelset turns about the axle by 1.
     */
    struct Turning
    {
      Vector axle, arm, velocity;
    };

    Turning turning() const;

    std::shared_ptr<const WheelOnRail> profiles;
    WheelsetPosition                   position;
    double                             sign; ///< of y, -1 on the left
    SurfaceKind                        surface_kind;
    RigidContact                       contact;
    ProfileCurve                       rail; ///< y and z along and under it
    ArcLengthAtY                       rail_at, wheel_at;
    double                             rail_origin; ///< arc length of contact
  };
} // namespace RollingContact::Profiles

#endif
