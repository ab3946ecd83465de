#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/contact_search.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

namespace RollingContact::Profiles
{
  namespace
  {
    const double step = 2e-4; // m, of the search along the wheel's profile

    // m: how far below its neighbours a gap may fall between two steps, with
    // curvatures across that differ by up to 400 1/m
    const double deepest_between = 400 * step * step / 8;

    const double largest_roll = 0.05; // rad

    double root(const std::function<double(const double)> &function,
                const double                               begin,
                const double                               end)
    {
      std::uintmax_t rounds = 100;
      const auto     found  = boost::math::tools::toms748_solve(
        function,
        begin,
        end,
        boost::math::tools::eps_tolerance<double>(),
        rounds);
      return (found.first + found.second) / 2;
    }
  } // namespace

  WheelOnRail::WheelOnRail(const ProfileCurve &wheel,
                           const ProfileCurve &rail,
                           const double        radius,
                           const double        tape_circle)
    : wheel(wheel)
    , rail(rail)
    , radius(radius)
    , tape_circle(tape_circle)
    , rail_at(this->rail)
    , rail_top(rail.highest())
  {}

  WheelOnRail::Point WheelOnRail::silhouette(const WheelsetPosition &position,
                                             const double arc_length) const
  {
    const CurvePoint at = wheel.at(arc_length);
    const double     r  = radius + at.z,
                 sine = std::clamp(-std::tan(position.yaw) * std::tan(at.angle),
                                   -1.,
                                   1.),
                 cosine = std::sqrt(1 - sine * sine);
    const double cr = std::cos(position.roll), sr = std::sin(position.roll),
                 cy = std::cos(position.yaw), sy = std::sin(position.yaw);
    // Rz(yaw), then Rx(roll)
    const double x = r * sine, y = tape_circle + at.y, z = r * cosine;
    const double turned_y = sy * x + cy * y;
    return {cy * x - sy * y,
            position.shift + cr * turned_y - sr * z,
            sr * turned_y + cr * z - radius};
  }

  std::pair<double, double>
  WheelOnRail::section(const WheelsetPosition &position,
                       const double            arc_length) const
  {
    const CurvePoint at = wheel.at(arc_length);
    const double     y  = (tape_circle + at.y) * std::cos(position.yaw),
                 z      = radius + at.z;
    const double cr = std::cos(position.roll), sr = std::sin(position.roll);
    return {position.shift + cr * y - sr * z, sr * y + cr * z - radius};
  }

  std::optional<double> WheelOnRail::gap(const WheelsetPosition &position,
                                         const double arc_length) const
  {
    const Point point = silhouette(position, arc_length);
    if (!rail_at.covers(point.y))
      return {};
    return rail.at(rail_at(point.y)).z - point.z;
  }

  RigidContact
  WheelOnRail::first_contact(const WheelsetPosition &position) const
  {
    const auto gap_or_none = [&](const double s) {
      return gap(position, s).value_or(std::numeric_limits<double>::max());
    };
    const int           n = std::ceil(wheel.length() / step);
    std::vector<double> gaps;
    for (int k = 0; k <= n; ++k)
      gaps.push_back(gap_or_none(wheel.length() * k / n));
    const double nearest = *std::min_element(gaps.begin(), gaps.end());
    if (nearest == std::numeric_limits<double>::max())
      throw InputError(
        "Profiles, lateral shift of " + significant(position.shift, 6) +
        " m: the wheel is not above the rail; check Profiles/Gauge, Flange "
        "back distance and the profiles.");
    std::pair<double, double> found{0., std::numeric_limits<double>::max()};
    for (int k = 0; k <= n; ++k)
      if (gaps[k] < nearest + 2 * deepest_between &&
          gaps[k] <= gaps[std::max(k - 1, 0)] &&
          gaps[k] <= gaps[std::min(k + 1, n)])
        {
          const auto here = boost::math::tools::brent_find_minima(
            gap_or_none,
            wheel.length() * std::max(k - 1, 0) / n,
            wheel.length() * std::min(k + 1, n) / n,
            std::numeric_limits<double>::digits / 2);
          if (here.second < found.second)
            found = here;
        }
    return at(position, found.first, found.second);
  }

  RigidContact WheelOnRail::at(const WheelsetPosition &position,
                               const double            arc_length,
                               const double            height) const
  {
    const CurvePoint wheel_point = wheel.at(arc_length);
    const Point      touching    = silhouette(position, arc_length);
    const double     rail_s      = rail_at(touching.y);
    const CurvePoint rail_point  = rail.at(rail_s);
    return {height,
            touching.x,
            rail_point.y,
            rail_point.z,
            wheel_point.y,
            rail_point.y - rail.at(rail_top).y,
            rail_point.angle,
            radius + wheel_point.z,
            -wheel.curvature(arc_length),
            rail.curvature(rail_s)};
  }

  ProfileCurve placed_rail(const ProfileCurve &section,
                           const double        inclination,
                           const double        gauge,
                           const double        gauge_height)
  {
    const ProfileCurve inclined = section.turned(-std::atan(inclination));
    const double       top      = inclined.highest();
    const double       depth    = inclined.at(top).z + gauge_height;
    if (!(inclined.points().front().z > depth))
      throw InputError(
        "Profiles/Gauge height = " + significant(gauge_height, 6) +
        " m: the rail's profile ends above it on the gauge side "
        "(first points).");
    const double face =
      root([&](const double s) { return inclined.at(s).z - depth; }, 0., top);
    return inclined.shifted(gauge / 2 - inclined.at(face).y,
                            -inclined.at(top).z);
  }

  WheelsetPosition mirrored(const WheelsetPosition &position)
  {
    return {-position.shift, -position.roll, -position.yaw};
  }

  double resting_roll(const WheelOnRail &right,
                      const WheelOnRail &left,
                      const double       shift,
                      const double       yaw)
  {
    const auto difference = [&](const double roll) {
      const WheelsetPosition position{shift, roll, yaw};
      return right.first_contact(position).height -
             left.first_contact(mirrored(position)).height;
    };
    if (&right == &left && shift == 0. && yaw == 0.)
      return 0.;
    if (difference(-largest_roll) * difference(largest_roll) > 0.)
      throw InputError("Profiles, lateral shift of " + significant(shift, 6) +
                       " m: no roll within " + significant(largest_roll, 2) +
                       " rad lets both wheels touch.");
    return root(difference, -largest_roll, largest_roll);
  }
} // namespace RollingContact::Profiles
