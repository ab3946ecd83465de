#include <rolling_contact/profiles/contact_frame.h>

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

    Vector
    cross(const Vector &a, const Vector &b)
    {
      return {{a[1] * b[2] - a[2] * b[1],
               a[2] * b[0] - a[0] * b[2],
               a[0] * b[1] - a[1] * b[0]}};
    }
  } // namespace



  ContactFrame::ContactFrame(std::shared_ptr<const WheelOnRail> profiles,
                             const WheelsetPosition            &position,
                             const bool                         is_left)
    : profiles(std::move(profiles))
    , position(is_left ? mirrored(position) : position)
    , sign(is_left ? -1. : 1.)
    , contact(this->profiles->first_contact(this->position))
    , rail(this->profiles->rail_profile()
             .shifted(-contact.y, -contact.z)
             .turned(-contact.angle))
    , rail_at(rail)
    , wheel_at(this->profiles->wheel_profile())
  {}



  double
  ContactFrame::angle() const
  {
    return sign * contact.angle;
  }



  double
  ContactFrame::track_y() const
  {
    return sign * contact.y;
  }



  ContactFrame::Vector
  ContactFrame::to_wheelset(const Vector &v) const
  {
    const double cr = std::cos(position.roll), sr = std::sin(position.roll),
                 cy = std::cos(position.yaw), sy = std::sin(position.yaw);
    // the transpose of Rx(roll) Rz(yaw)
    const double y = cr * v[1] + sr * v[2];
    return {{cy * v[0] + sy * y, -sy * v[0] + cy * y, -sr * v[1] + cr * v[2]}};
  }



  std::optional<ContactFrame::WheelPoint>
  ContactFrame::wheel_point(const double x, const double along) const
  {
    const double c = std::cos(contact.angle), s = std::sin(contact.angle),
                 wheel_radius = profiles->wheel_radius();
    // z into the rail, and the plane's point from the middle of the axle
    const Vector normal = to_wheelset({{0., -s, c}}),
                 from   = to_wheelset(
                   {{contact.x - x,
                       contact.y + along * c - position.shift,
                       contact.z + along * s - contact.height + wheel_radius}});
    WheelPoint found{0., 0.};
    for (unsigned int round = 0; round < 30; ++round)
      {
        Vector at;
        for (unsigned int d = 0; d < 3; ++d)
          at[d] = from[d] + found.depth * normal[d];
        const double y        = at[1] - profiles->tape_circle_place(),
                     distance = std::hypot(at[0], at[2]);
        if (!wheel_at.covers(y))
          return {};
        const CurvePoint point = profiles->wheel_profile().at(wheel_at(y));
        const double     steepness =
          (at[0] * normal[0] + at[2] * normal[2]) / distance -
          std::tan(point.angle) * normal[1];
        if (!(steepness > least_steepness))
          return {};
        found.radius      = wheel_radius + point.z;
        const double step = (distance - found.radius) / steepness;
        found.depth -= step;
        if (std::abs(step) < accuracy)
          return found;
      }
    return {};
  }



  std::optional<double>
  ContactFrame::gap(const double x, const double y) const
  {
    const double along = sign * y;
    if (!rail_at.covers(along))
      return {};
    const auto wheel = wheel_point(x, along);
    if (!wheel)
      return {};
    return rail.at(rail_at(along)).z - wheel->depth;
  }



  double
  ContactFrame::rail_angle(const double y) const
  {
    const double along = sign * y;
    return rail_at.covers(along) ? sign * rail.at(rail_at(along)).angle : 0.;
  }



  double
  ContactFrame::turn_of_normal(
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



  double
  ContactFrame::spin_of_cone() const
  {
    return -sign * std::sin(contact.angle) / contact.rolling_radius;
  }



  double
  ContactFrame::slip_beyond_spin(const double y) const
  {
    const auto wheel = wheel_point(0., sign * y);
    return wheel ? (wheel->radius - contact.rolling_radius) /
                       contact.rolling_radius +
                     y * spin_of_cone()
                 : 0.;
  }



  Creepages
  ContactFrame::creepages(const double                 speed,
                          const std::optional<double> &pitch_rate) const
  {
    const double cr = std::cos(position.roll), sr = std::sin(position.roll),
                 cy = std::cos(position.yaw), sy = std::sin(position.yaw);
    const Vector axle{{-sy, cr * cy, sr * cy}};
    const Vector arm{{contact.x,
                      contact.y - position.shift,
                      contact.z - contact.height + profiles->wheel_radius()}};
    const Vector turning = cross(axle, arm);
    const double rate    = pitch_rate.value_or(-speed / turning[0]);
    const double c = std::cos(contact.angle), s = std::sin(contact.angle);
    const double forwards = speed + rate * turning[0],
                 across   = rate * (c * turning[1] + s * turning[2]),
                 about    = rate * (-s * axle[1] + c * axle[2]);
    const double scale    = 1 / std::abs(speed);
    return {-forwards * scale, sign * across * scale, -sign * about * scale};
  }



  std::array<double, 2>
  ContactFrame::in_track(const double force_y, const double force_z) const
  {
    const double c = std::cos(angle()), s = std::sin(angle());
    // y along (c, s) and z along (s, -c) of (right, down)
    return {{c * force_y + s * force_z, -s * force_y + c * force_z}};
  }



  std::array<double, 2>
  ContactFrame::point_in_track(const double y, const double z) const
  {
    const auto [across, upwards] = in_track(y, z);
    return {{track_y() + across, upwards - contact.z}};
  }



  std::optional<double>
  ContactFrame::rail_height(const double y) const
  {
    const double along = sign * y;
    if (!rail_at.covers(along))
      return {};
    return -rail.at(rail_at(along)).z;
  }



  std::vector<std::array<double, 2>>
  ContactFrame::rail_section() const
  {
    std::vector<std::array<double, 2>> section;
    for (const CurvePoint &point : profiles->rail_profile().points())
      section.push_back({{sign * point.y, -point.z}});
    return section;
  }



  std::vector<std::array<double, 2>>
  ContactFrame::wheel_section() const
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
