#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/profile_file.h>
#include <rolling_contact/surfaces/rail_groove.h>
#include <rolling_contact/surfaces/smoothing_spline.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Profiles
{
  namespace
  {
    const double repeated = 1e-7; // m, between points that are one

    const double shortest = 5e-3, longest = 0.5; // m, of a profile

    // rad: a turn of the one at a point beside turns below the other
    const double corner = M_PI / 6, smooth = M_PI / 18;

    using Points = std::vector<MeasuredPoint>;

    double distance(const MeasuredPoint &a, const MeasuredPoint &b)
    {
      return std::hypot(b.y - a.y, b.z - a.z);
    }

    void drop_repeated(Points &points)
    {
      points.erase(std::unique(points.begin(),
                               points.end(),
                               [](const auto &a, const auto &b) {
                                 return distance(a, b) < repeated;
                               }),
                   points.end());
    }

    /** Throws InputError if the points are too long a way for their places. */
    void check_order(const Points      &points,
                     const double       length,
                     const std::string &name)
    {
      double farthest = 0.;
      for (const MeasuredPoint &point : points)
        farthest = std::max(farthest, distance(points.front(), point));
      if (length > longest && farthest < longest)
        throw InputError(name + ": from point to point the profile is " +
                         significant(length, 3) + " m long, though none is " +
                         "farther than " + significant(farthest, 3) +
                         " m from the first: they must follow each other "
                         "along the section.");
    }

    void check_length(const Points &points, const std::string &name)
    {
      double length = 0.;
      for (std::size_t k = 1; k < points.size(); ++k)
        length += distance(points[k - 1], points[k]);
      check_order(points, length, name);
      if (!(length > shortest && length < longest))
        throw InputError(name + ": the profile is " + significant(length, 3) +
                         " m long; profiles are " + significant(shortest, 2) +
                         " to " + significant(longest, 2) +
                         " m. Check Profiles/File unit (m for one unit of the "
                         "file: 1 for m, 1e-3 for mm), or units.len.f in the "
                         "file.");
    }

    /**
     * Throws InputError if two sides of the polygon meet.
     */
    void check_crossings(const Points &points, const std::string &name)
    {
      if (const auto found = first_crossing(points))
        throw InputError(name + ": the profile crosses itself between points " +
                         std::to_string(found->first + 1) + " and " +
                         std::to_string(found->second + 2) +
                         ": they must follow each other along the section.");
    }

    [[noreturn]] void refuse_way_up(const std::string &name,
                                    const std::string &what)
    {
      throw InputError(name + ": " + what);
    }

    /**
     * Throws InputError unless it is the profile of a right-hand wheel or rail
     * with z down.
     */
    void check_way_up(const Points      &points,
                      const ProfileKind  kind,
                      const std::string &name)
    {
      const auto lowest   = std::max_element(points.begin(),
                                           points.end(),
                                           [](const auto &a, const auto &b) {
                                             return a.z < b.z;
                                           }),
                 highest  = std::min_element(points.begin(),
                                            points.end(),
                                            [](const auto &a, const auto &b) {
                                              return a.z < b.z;
                                            });
      const double middle = (points.front().y + points.back().y) / 2;
      if (kind == ProfileKind::rail)
        {
          const double ends = (points.front().z + points.back().z) / 2;
          if (ends - highest->z < lowest->z - ends)
            refuse_way_up(name,
                          "the ends of this rail's profile stand above its "
                          "middle; z is downwards here: set Profiles/Rail "
                          "mirror = z.");
          return;
        }
      // the flange is the narrow part: tread and flange differ in their means
      double mean = 0.;
      for (std::size_t k = 1; k < points.size(); ++k)
        mean +=
          (points[k].y - points[k - 1].y) * (points[k].z + points[k - 1].z) / 2;
      mean /= points.back().y - points.front().y;
      if (lowest->z - mean < mean - highest->z)
        refuse_way_up(name,
                      "the flange of this wheel's profile points upwards; z is "
                      "downwards here: set Profiles/Wheel mirror = z.");
      if (lowest->y > middle)
        refuse_way_up(name,
                      "the flange of this wheel's profile is at larger y than "
                      "the tread; y is towards the field side of the "
                      "right-hand wheel here: set Profiles/Wheel mirror = "
                      "y.");
    }

    /**
     * The last point of each smooth part: between them the profile has corners.
     */
    std::vector<std::size_t> corners(const Points &points)
    {
      const auto turn = [&](const std::size_t k) {
        if (k == 0 || k + 1 >= points.size())
          return 0.;
        const double before = std::atan2(points[k].z - points[k - 1].z,
                                         points[k].y - points[k - 1].y),
                     behind = std::atan2(points[k + 1].z - points[k].z,
                                         points[k + 1].y - points[k].y);
        return std::abs(std::remainder(behind - before, 2 * M_PI));
      };
      std::vector<std::size_t> found;
      for (std::size_t k = 3; k + 3 < points.size(); ++k)
        if (turn(k) > corner && turn(k - 1) < smooth && turn(k + 1) < smooth)
          found.push_back(k);
      found.push_back(points.size() - 1);
      return found;
    }

    /**
     * Adds the smoothed points from one place to another. Where a part begins
     * in a corner its first point is moved into it.
     */
    void add_smoothed(const Points            &points,
                      const std::size_t        begin,
                      const std::size_t        end,
                      const double             smoothing_length,
                      std::vector<CurvePoint> &curve)
    {
      std::vector<double> s, y, z;
      for (std::size_t k = begin; k <= end; ++k)
        {
          s.push_back(
            k == begin ? 0. : s.back() + distance(points[k - 1], points[k]));
          y.push_back(points[k].y);
          z.push_back(points[k].z);
        }
      const SmoothingSpline across(s, y, smoothing_length),
        down(s, z, smoothing_length);
      for (std::size_t k = 0; k < s.size(); ++k)
        {
          const double angle = std::atan2(down.slopes[k], across.slopes[k]);
          const double into  = k == 0 && !curve.empty() ? 10 * repeated : 0.;
          curve.push_back({across.values[k] + into * std::cos(angle),
                           down.values[k] + into * std::sin(angle),
                           angle});
          // angles go on without jumps of a full turn
          if (curve.size() > 1)
            {
              const double before = curve[curve.size() - 2].angle;
              curve.back().angle =
                before + std::remainder(angle - before, 2 * M_PI);
            }
        }
    }
  } // namespace

  std::optional<std::pair<std::size_t, std::size_t>>
  first_crossing(const std::vector<MeasuredPoint> &points)
  {
    const auto side =
      [&](const std::size_t a, const std::size_t b, const std::size_t c) {
        return (points[b].y - points[a].y) * (points[c].z - points[a].z) -
               (points[b].z - points[a].z) * (points[c].y - points[a].y);
      };
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      for (std::size_t j = i + 2; j + 1 < points.size(); ++j)
        if (side(i, i + 1, j) * side(i, i + 1, j + 1) < 0. &&
            side(j, j + 1, i) * side(j, j + 1, i + 1) < 0.)
          return std::make_pair(i, j);
    return {};
  }

  ProfileCurve profile_of_points(std::vector<MeasuredPoint> points,
                                 const ProfileKind          kind,
                                 const double               smoothing_length,
                                 const std::string         &name)
  {
    drop_repeated(points);
    check_length(points, name);
    if (points.back().y < points.front().y)
      std::reverse(points.begin(), points.end());
    if (kind == ProfileKind::rail)
      leave_out_keeper(points, name);
    check_way_up(points, kind, name);
    check_crossings(points, name);
    std::vector<CurvePoint> curve;
    std::size_t             begin = 0;
    for (const std::size_t end : corners(points))
      {
        add_smoothed(points, begin, end, smoothing_length, curve);
        begin = end;
      }
    return ProfileCurve(curve);
  }
} // namespace RollingContact::Profiles
