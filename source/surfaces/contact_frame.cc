#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/contact_frame.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Profiles
{
  namespace
  {
    /// of the wheel's surface over the plane: cosine of the angle between their
    /// normals, below which nothing is found
    const double least_steepness = 0.05;

    const double accuracy = 1e-12; // m, of points on the wheel

    using Vector = std::array<double, 3>;

    Vector cross(const Vector &a, const Vector &b)
    {
      return {{a[1] * b[2] - a[2] * b[1],
               a[2] * b[0] - a[0] * b[2],
               a[0] * b[1] - a[1] * b[0]}};
    }
  } // namespace

  ContactFrame::ContactFrame(std::shared_ptr<const WheelOnRail> profiles,
                             const WheelsetPosition            &position,
                             const bool                         is_left,
                             const SurfaceKind                  kind)
    : ContactFrame(profiles,
                   is_left ? mirrored(position) : position,
                   is_left ? -1. : 1.,
                   kind,
                   profiles->first_contact(is_left ? mirrored(position)
                                                   : position))
  {}

  ContactFrame::ContactFrame(std::shared_ptr<const WheelOnRail> profiles,
                             const WheelsetPosition            &position,
                             const double                       sign,
                             const SurfaceKind                  kind,
                             const RigidContact                &contact)
    : profiles(std::move(profiles))
    , position(position)
    , sign(sign)
    , surface_kind(kind)
    , contact(contact)
    , rail(this->profiles->rail_profile()
             .shifted(-contact.y, -contact.z)
             .turned(-contact.angle))
    , rail_at(rail)
    , wheel_at(this->profiles->wheel_profile())
    , rail_origin(rail_at(0.))
  {}

  std::shared_ptr<const ContactFrame>
  ContactFrame::at_patch(const double s, const double turn) const
  {
    const auto arc_length = wheel_arc_length(s);
    if (!arc_length)
      throw InputError(
        "Profiles/Contact surface = loaded plane: the wheel does "
        "not reach to the middle of the patch, " +
        millimetres(s) +
        " from the first contact; take another Profiles/Lateral "
        "shift or less load.");
    RigidContact origin = profiles->at(position, *arc_length, contact.height);
    origin.angle        = contact.angle + sign * turn;
    return std::shared_ptr<const ContactFrame>(
      new ContactFrame(profiles, position, sign, surface_kind, origin));
  }

  double ContactFrame::angle() const
  {
    return sign * contact.angle;
  }

  double ContactFrame::track_y() const
  {
    return sign * contact.y;
  }

  ContactFrame::Vector ContactFrame::to_wheelset(const Vector &v) const
  {
    const double cr = std::cos(position.roll), sr = std::sin(position.roll),
                 cy = std::cos(position.yaw), sy = std::sin(position.yaw);
    // the transpose of Rx(roll) Rz(yaw)
    const double y = cr * v[1] + sr * v[2];
    return {{cy * v[0] + sy * y, -sy * v[0] + cy * y, -sr * v[1] + cr * v[2]}};
  }

  std::optional<ContactFrame::WheelPoint>
  ContactFrame::wheel_point(const double x, const CurvePoint &point) const
  {
    const double c_n          = std::cos(contact.angle + point.angle),
                 s_n          = std::sin(contact.angle + point.angle),
                 wheel_radius = profiles->wheel_radius();
    // the normal into the rail, and the point from the middle of the axle
    const Vector at     = in_track_of_right(x, point),
                 normal = to_wheelset({{0., -s_n, c_n}}),
                 from   = to_wheelset({{at[0],
                                        at[1] - position.shift,
                                        at[2] - contact.height + wheel_radius}});
    WheelPoint found{0., 0., 0.};
    for (unsigned int round = 0; round < 30; ++round)
      {
        Vector at;
        for (unsigned int d = 0; d < 3; ++d)
          at[d] = from[d] + found.depth * normal[d];
        const double y        = at[1] - profiles->tape_circle_place(),
                     distance = std::hypot(at[0], at[2]);
        if (!wheel_at.covers(y))
          return {};
        found.arc_length = wheel_at(y);
        const CurvePoint profile =
          profiles->wheel_profile().at(found.arc_length);
        const double steepness =
          (at[0] * normal[0] + at[2] * normal[2]) / distance -
          std::tan(profile.angle) * normal[1];
        if (!(steepness > least_steepness))
          return {};
        found.radius      = wheel_radius + profile.z;
        const double step = (distance - found.radius) / steepness;
        found.depth -= step;
        if (std::abs(step) < accuracy)
          return found;
      }
    return {};
  }

  bool ContactFrame::covers(const double s) const
  {
    const double along = sign * s;
    if (surface_kind == SurfaceKind::plane)
      return rail_at.covers(along);
    return rail_origin + along >= 0. && rail_origin + along <= rail.length();
  }

  double ContactFrame::rail_arc_length(const double s) const
  {
    const double along = sign * s;
    return surface_kind == SurfaceKind::plane ? rail_at(along)
                                              : rail_origin + along;
  }

  CurvePoint ContactFrame::rail_point(const double s) const
  {
    return rail.at(rail_arc_length(s));
  }

  CurvePoint ContactFrame::surface_point(const double s) const
  {
    return surface_kind == SurfaceKind::plane ? CurvePoint{sign * s, 0., 0.}
                                              : rail_point(s);
  }

  SurfacePoint ContactFrame::surface(const double s) const
  {
    const CurvePoint point = surface_point(s);
    return {sign * point.y, -point.z, sign * point.angle};
  }

  std::optional<double> ContactFrame::gap(const double x, const double s) const
  {
    if (!covers(s))
      return {};
    const auto wheel = wheel_point(x, surface_point(s));
    if (!wheel)
      return {};
    return (surface_kind == SurfaceKind::plane ? rail_point(s).z : 0.) -
           wheel->depth;
  }

  std::optional<double> ContactFrame::wheel_arc_length(const double s) const
  {
    if (!covers(s))
      return {};
    const auto wheel = wheel_point(0., surface_point(s));
    if (!wheel)
      return {};
    return wheel->arc_length;
  }

  double ContactFrame::rail_angle(const double s) const
  {
    return covers(s) ? sign * (rail_point(s).angle - surface_point(s).angle)
                     : 0.;
  }

  double ContactFrame::turn_of_normal(
    std::vector<std::pair<double, double>> load) const
  {
    std::sort(load.begin(), load.end());
    double total = 0.;
    for (const auto &entry : load)
      total += entry.second;
    const double share = 0.05;
    double       below = 0., first = 0., last = 0.;
    for (const auto &[y, force] : load)
      {
        if (below <= share * total)
          first = y;
        if (below < (1 - share) * total)
          last = y;
        below += force;
      }
    return std::abs(rail_angle(last) - rail_angle(first));
  }

  double ContactFrame::spin_of_cone() const
  {
    return -sign * std::sin(contact.angle) / contact.rolling_radius;
  }

  double ContactFrame::slip_beyond_spin(const double s) const
  {
    if (!covers(s))
      return 0.;
    const CurvePoint point = surface_point(s);
    const auto       wheel = wheel_point(0., point);
    return wheel ? (wheel->radius - contact.rolling_radius) /
                       contact.rolling_radius +
                     sign * point.y * spin_of_cone()
                 : 0.;
  }

  ContactFrame::Turning ContactFrame::turning() const
  {
    const double cr = std::cos(position.roll), sr = std::sin(position.roll),
                 cy = std::cos(position.yaw), sy = std::sin(position.yaw);
    const Vector axle{{-sy, cr * cy, sr * cy}};
    const Vector arm{{contact.x,
                      contact.y - position.shift,
                      contact.z - contact.height + profiles->wheel_radius()}};
    return {axle, arm, cross(axle, arm)};
  }

  double ContactFrame::slip_of_rolling(const double x, const double s) const
  {
    const Turning turns = turning();
    const double  c = std::cos(contact.angle), sine = std::sin(contact.angle);
    const CurvePoint point = surface_point(s);
    const Vector     velocity =
      cross(turns.axle,
            {{-x, point.y * c - point.z * sine, point.y * sine + point.z * c}});
    // for a turn about the axle by 1, that about the plane's normal apart
    const double about  = -sine * turns.axle[1] + c * turns.axle[2],
                 across = c * velocity[1] + sine * velocity[2] + about * x,
                 down   = -sine * velocity[1] + c * velocity[2];
    return sign *
           (across * std::cos(point.angle) + down * std::sin(point.angle)) /
           -turns.velocity[0];
  }

  GeneralisedVelocities
  ContactFrame::velocities(const WheelsetMotion &motion) const
  {
    const double scale   = 1 / std::abs(motion.speed),
                 turn    = motion.speed * motion.curvature * scale,
                 along   = motion.speed * scale,
                 rolling = -(along - turn * track_y()) / turning().velocity[0];
    return {{along,
             motion.to_the_side * scale,
             turn,
             motion.pitch_rate ? *motion.pitch_rate * scale : rolling}};
  }

  Creepages ContactFrame::creepages(const WheelsetMotion &motion) const
  {
    const auto [along, sideways, turn, rate] = velocities(motion);
    const Turning turns                      = turning();
    const double  c = std::cos(contact.angle), s = std::sin(contact.angle);
    const double forwards = along - turn * track_y() + rate * turns.velocity[0],
                 across   = c * (sign * (sideways + turn * contact.x) +
                               rate * turns.velocity[1]) +
                          s * rate * turns.velocity[2],
                 about = rate * (-s * turns.axle[1] + c * turns.axle[2]) +
                         sign * turn * c;
    return {-forwards, sign * across, -sign * about};
  }

  ContactFrame::Vector
  ContactFrame::in_track_of_right(const double x, const CurvePoint &point) const
  {
    const double c = std::cos(contact.angle), s = std::sin(contact.angle);
    return {{contact.x - x,
             contact.y + point.y * c - point.z * s,
             contact.z + point.y * s + point.z * c}};
  }

  PlaceInTrack ContactFrame::place_in_track(const double x,
                                            const double s,
                                            const double angle) const
  {
    const CurvePoint surface =
      covers(s) ? surface_point(s) : CurvePoint{sign * s, 0., 0.};
    // the wheel goes along its round surface: its speed is that below the axle
    const auto   wheel = wheel_point(0., surface);
    const double depth = wheel ? wheel->depth : 0.,
                 face  = contact.angle + surface.angle,
                 slope = contact.angle + sign * angle;
    Vector at          = in_track_of_right(x, surface);
    at[1] -= depth * std::sin(face);
    at[2] += depth * std::cos(face);
    const Vector turn =
      cross(turning().axle,
            {{at[0],
              at[1] - position.shift,
              at[2] - contact.height + profiles->wheel_radius()}});
    const double c = std::cos(slope), sine = std::sin(slope);
    return {{{at[0], sign * at[1], at[2]}},
            sign * slope,
            {{-1., 0., sign * at[1], -turn[0]}},
            {{0., c, c * at[0], sign * (c * turn[1] + sine * turn[2])}}};
  }

  std::array<double, 2> ContactFrame::in_track(const double force_y,
                                               const double force_z) const
  {
    const double c = std::cos(angle()), s = std::sin(angle());
    // y along (c, s) and z along (s, -c) of (right, down)
    return {{c * force_y + s * force_z, -s * force_y + c * force_z}};
  }

  std::array<double, 2> ContactFrame::point_in_track(const double y,
                                                     const double z) const
  {
    const auto [across, upwards] = in_track(y, z);
    return {{track_y() + across, upwards - contact.z}};
  }

  std::optional<std::array<double, 2>>
  ContactFrame::rail_in_track(const double s) const
  {
    if (!covers(s))
      return {};
    const CurvePoint point = rail_point(s);
    return point_in_track(sign * point.y, -point.z);
  }

  std::vector<std::array<double, 2>> ContactFrame::rail_section() const
  {
    std::vector<std::array<double, 2>> section;
    for (const CurvePoint &point : profiles->rail_profile().points())
      section.push_back({{sign * point.y, -point.z}});
    return section;
  }

  std::vector<std::array<double, 2>> ContactFrame::wheel_section() const
  {
    std::vector<std::array<double, 2>> section;
    for (const double s : profiles->wheel_profile().arc_lengths())
      {
        const auto [across, down] = profiles->section(position, s);
        section.push_back({{sign * across, -(down + contact.height)}});
      }
    return section;
  }
} // namespace RollingContact::Profiles
