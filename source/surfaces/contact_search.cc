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
#include <utility>

namespace RollingContact::Profiles
{
  namespace
  {
    const double step = 2e-4; // m, of the search along the wheel's profile

    // m: how far below its neighbours a gap may fall between two steps, with
    // curvatures across that differ by up to 400 1/m
    const double deepest_between = 400 * step * step / 8;

    const double largest_roll = 0.05; // rad

    const double none = std::numeric_limits<double>::max(); // beside the rail

    using Function = std::function<double(const double)>;

    double root(const Function &function,
                const double    begin,
                const double    at_begin,
                const double    end,
                const double    at_end)
    {
      if (begin > end)
        return root(function, end, at_end, begin, at_begin);
      std::uintmax_t rounds = 100;
      const auto     found  = boost::math::tools::toms748_solve(
        function,
        begin,
        end,
        at_begin,
        at_end,
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
    , rail_heights(this->rail)
    , rail_top(rail.highest())
  {
    const int n = std::ceil(wheel.length() / step);
    for (int k = 0; k <= n; ++k)
      steps.push_back(wheel.at(wheel.length() * k / n));
  }

  WheelOnRail::Point WheelOnRail::silhouette(const WheelsetPosition &position,
                                             const CurvePoint       &at) const
  {
    const double r    = radius + at.z,
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

  std::vector<double>
  WheelOnRail::low_gaps(const WheelsetPosition &position) const
  {
    const int           n = steps.size() - 1;
    std::vector<double> least(n + 1, none), gaps(n + 1, none);
    double              nearest = none;
    for (int k = 0; k <= n; ++k)
      {
        const Point point = silhouette(position, steps[k]);
        if (!rail_at.covers(point.y))
          continue;
        const auto [above, below] = rail_heights(point.y);
        least[k]                  = above - point.z;
        nearest                   = std::min(nearest, below - point.z);
      }
    for (int k = 0; k <= n; ++k)
      if (least[k] < nearest + 2 * deepest_between)
        for (int j = std::max(k - 1, 0); j <= std::min(k + 1, n); ++j)
          if (gaps[j] == none)
            gaps[j] = gap(position, wheel.length() * j / n).value_or(none);
    return gaps;
  }

  RigidContact
  WheelOnRail::first_contact(const WheelsetPosition &position) const
  {
    const auto gap_or_none = [&](const double s) {
      return gap(position, s).value_or(none);
    };
    const std::vector<double> gaps = low_gaps(position);
    const int                 n    = gaps.size() - 1;
    const double nearest = *std::min_element(gaps.begin(), gaps.end());
    if (nearest == none)
      throw InputError(
        "Profiles, lateral shift of " + significant(position.shift, 6) +
        " m: the wheel is not above the rail; check Profiles/Gauge, Flange "
        "back distance and the profiles.");
    std::pair<double, double> found{0., none};
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

  std::optional<double> y_of_gauge_face(const ProfileCurve &rail,
                                        const double        gauge_height)
  {
    const double top   = rail.highest();
    const double depth = rail.at(top).z + gauge_height;
    if (!(rail.points().front().z > depth))
      return {};
    const auto below = [&](const double s) { return rail.at(s).z - depth; };
    return rail.at(root(below, 0., below(0.), top, below(top))).y;
  }

  ProfileCurve placed_rail(const ProfileCurve &section,
                           const double        inclination,
                           const double        gauge,
                           const double        gauge_height)
  {
    const ProfileCurve inclined = section.turned(-std::atan(inclination));
    const auto         face     = y_of_gauge_face(inclined, gauge_height);
    if (!face)
      throw InputError(
        "Profiles/Gauge height = " + significant(gauge_height, 6) +
        " m: the rail's profile ends above it on the gauge side "
        "(first points).");
    return inclined.shifted(gauge / 2 - *face,
                            -inclined.at(inclined.highest()).z);
  }

  WheelsetPosition mirrored(const WheelsetPosition &position)
  {
    return {-position.shift, -position.roll, -position.yaw};
  }

  double resting_roll(const WheelOnRail           &right,
                      const WheelOnRail           &left,
                      const std::array<double, 2> &shifts,
                      const double                 yaw)
  {
    const auto difference = [&](const double roll) {
      return right.first_contact({shifts[0], roll, yaw}).height -
             left.first_contact(mirrored({shifts[1], roll, yaw})).height;
    };
    if (&right == &left && shifts[0] == -shifts[1] && yaw == 0.)
      return 0.;
    // one side comes down by as much as the other goes up
    const double slope =
      -(right.tape_circle_place() + left.tape_circle_place());
    const auto within = [](const double roll) {
      return std::clamp(roll, -largest_roll, largest_roll);
    };
    double begin = 0., at_begin = difference(begin);
    if (at_begin == 0.)
      return begin;
    double end = within(-at_begin / slope), at_end = difference(end);
    while (at_begin * at_end > 0. && std::abs(end) < largest_roll)
      {
        const double further = within(end + 2 * (end - begin));
        begin                = std::exchange(end, further);
        at_begin             = std::exchange(at_end, difference(end));
      }
    if (at_begin * at_end > 0.)
      throw InputError("Profiles, lateral shift of " +
                       significant(shifts[0], 6) + " m: no roll within " +
                       significant(largest_roll, 2) +
                       " rad lets both wheels touch.");
    return root(difference, begin, at_begin, end, at_end);
  }
} // namespace RollingContact::Profiles
