#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/profile_doubts.h>
#include <rolling_contact/surfaces/rail_groove.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Profiles
{
  namespace
  {
    // m across: wheels have 100 to 150 mm, heads of rails 40 to 80 mm
    const double narrow_wheel = 0.05, narrow_rail = 0.03;

    // m: where the tip of a flange may be beside the tape circle, -55 mm with
    // S1002 and flanges of other railways near it
    const double farthest_tip = -0.075, nearest_tip = -0.03;

    // m and over the median distance: a stretch without points
    const double long_gap = 4e-3, unusual_gap = 5.;

    // m, standard deviation: profiles are measured to some um
    const double much_scatter = 12e-6;

    std::string in_mm(const double length)
    {
      return significant(1e3 * length, 3);
    }

    /** From the least to the largest y or z. */
    double extent(const std::vector<MeasuredPoint> &points,
                  double MeasuredPoint::*const coordinate)
    {
      const auto [first, last] =
        std::minmax_element(points.begin(),
                            points.end(),
                            [&](const auto &a, const auto &b) {
                              return a.*coordinate < b.*coordinate;
                            });
      return (*last).*coordinate - (*first).*coordinate;
    }

    std::string doubt_of_width(const std::vector<MeasuredPoint> &points,
                               const ProfileKind                 kind,
                               const std::string                &name)
    {
      const bool   is_wheel = kind == ProfileKind::wheel;
      const double width    = extent(points, &MeasuredPoint::y),
                   height   = extent(points, &MeasuredPoint::z),
                   narrow   = is_wheel ? narrow_wheel : narrow_rail;
      if (width > narrow)
        return "";
      return name + ": the profile is " + in_mm(width) + " mm wide, " +
             (is_wheel ? "wheels have 100 to 150 mm"
                       : "heads of rails have 40 to 80 mm") +
             (height > narrow
                ? ", and " + in_mm(height) +
                    " mm high; is the first column y, across, and the second z?"
                : "; is Profiles/File unit right (0.0254 for inches)?");
    }

    /**
     * Standard deviation of points about a smooth curve, from the median of
     * their third differences across it, e = (p_0 - 3 p_1 + 3 p_2 - p_3) / 2,
     * whose deviation is sqrt(5) times that of equally long steps. Units: m.
     */
    double scatter(const std::vector<MeasuredPoint> &points)
    {
      std::vector<double> across;
      for (std::size_t k = 3; k < points.size(); ++k)
        {
          const MeasuredPoint &a = points[k - 3], &b = points[k - 2],
                              &c = points[k - 1], &d = points[k];
          const double y = d.y - a.y, z = d.z - a.z, length = std::hypot(y, z);
          if (length > 0.)
            across.push_back(std::abs(y * (a.z - 3 * b.z + 3 * c.z - d.z) -
                                      z * (a.y - 3 * b.y + 3 * c.y - d.y)) /
                             (2 * length));
        }
      if (across.empty())
        return 0.;
      const auto middle = across.begin() + across.size() / 2;
      std::nth_element(across.begin(), middle, across.end());
      const double median_of_normal = 0.6745; // over the standard deviation
      return *middle / median_of_normal / std::sqrt(5.);
    }

    std::string doubt_of_scatter(const std::vector<MeasuredPoint> &points,
                                 const std::string                &name)
    {
      const double found = scatter(points);
      if (found < much_scatter)
        return "";
      return name + ": the points scatter by about " +
             significant(1e6 * found, 2) +
             " um about a smooth line; 5 um move the contact of profiles that "
             "lie close by about 0.5 mm.";
    }

    std::string doubt_of_origin(const std::vector<MeasuredPoint> &points,
                                const std::string                &name)
    {
      const double tip =
        std::max_element(points.begin(),
                         points.end(),
                         [](const auto &a, const auto &b) { return a.z < b.z; })
          ->y;
      if (tip > farthest_tip && tip < nearest_tip)
        return "";
      return name + ": the tip of the flange is at y = " + in_mm(tip) +
             " mm; from the tape circle, which is y = 0 of a wheel's profile, "
             "it is at about -55 mm: is the file moved across? "
             "Profiles/Wheel profile shift moves it.";
    }

    /** A sentence for the longest stretch without points. */
    std::string doubt_of_gaps(const std::vector<MeasuredPoint> &points,
                              const std::string                &name)
    {
      std::vector<double> steps;
      for (std::size_t k = 1; k < points.size(); ++k)
        steps.push_back(std::hypot(points[k].y - points[k - 1].y,
                                   points[k].z - points[k - 1].z));
      std::vector<double> sorted = steps;
      std::nth_element(sorted.begin(),
                       sorted.begin() + sorted.size() / 2,
                       sorted.end());
      const double usual = sorted[sorted.size() / 2];
      const auto   k     = static_cast<std::size_t>(
        std::max_element(steps.begin(), steps.end()) - steps.begin());
      if (steps[k] < long_gap || steps[k] < unusual_gap * usual)
        return "";
      const auto [from, to] = std::minmax(points[k].y, points[k + 1].y);
      return name + ": no points for " + in_mm(steps[k]) +
             " mm, from y = " + in_mm(from) + " to " + in_mm(to) +
             " mm: a spline bridges them, and what touches there is a guess.";
    }

    std::string doubt_of_groove(std::vector<MeasuredPoint> points,
                                const std::string         &name)
    {
      if (points.back().y < points.front().y)
        std::reverse(points.begin(), points.end());
      const auto groove = groove_of(points);
      if (!groove)
        return "";
      return name + ": the rail has a groove " + in_mm(groove->depth) +
             " mm deep, and its profile ends at the floor of that, at y = " +
             in_mm(groove->floor_y) +
             " mm: a flange that touches the keeper beyond it is not found.";
    }
  } // namespace

  std::vector<std::string>
  doubts_of_points(const std::vector<MeasuredPoint> &points,
                   const ProfileKind                 kind,
                   const std::string                &name)
  {
    const std::string of_width = doubt_of_width(points, kind, name);
    if (!of_width.empty())
      return {of_width};
    std::vector<std::string> doubts;
    for (const std::string &doubt :
         {kind == ProfileKind::wheel ? doubt_of_origin(points, name)
                                     : doubt_of_groove(points, name),
          doubt_of_gaps(points, name),
          doubt_of_scatter(points, name)})
      if (!doubt.empty())
        doubts.push_back(doubt);
    return doubts;
  }
} // namespace RollingContact::Profiles
