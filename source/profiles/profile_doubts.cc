#include <rolling_contact/base/text.h>
#include <rolling_contact/profiles/profile_doubts.h>

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



    std::string
    in_mm(const double length)
    {
      return significant(1e3 * length, 3);
    }



    double
    width_of(const std::vector<MeasuredPoint> &points)
    {
      const auto [first, last] =
        std::minmax_element(points.begin(),
                            points.end(),
                            [](const auto &a, const auto &b) {
                              return a.y < b.y;
                            });
      return last->y - first->y;
    }



    std::string
    doubt_of_width(const double       width,
                   const ProfileKind  kind,
                   const std::string &name)
    {
      const bool is_wheel = kind == ProfileKind::wheel;
      if (width > (is_wheel ? narrow_wheel : narrow_rail))
        return "";
      return name + ": the profile is " + in_mm(width) + " mm wide, " +
             (is_wheel ? "wheels have 100 to 150 mm"
                       : "heads of rails have 40 to 80 mm") +
             "; is Profiles/File unit right (0.0254 for inches)?";
    }



    std::string
    doubt_of_origin(const std::vector<MeasuredPoint> &points,
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
             "it is at about -55 mm: is the file moved across?";
    }



    /** A sentence for the longest stretch without points. */
    std::string
    doubt_of_gaps(const std::vector<MeasuredPoint> &points,
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
  } // namespace



  std::vector<std::string>
  doubts_of_points(const std::vector<MeasuredPoint> &points,
                   const ProfileKind                 kind,
                   const std::string                &name)
  {
    const std::string of_width = doubt_of_width(width_of(points), kind, name);
    if (!of_width.empty())
      return {of_width};
    std::vector<std::string> doubts;
    for (const std::string &doubt :
         {kind == ProfileKind::wheel ? doubt_of_origin(points, name) : "",
          doubt_of_gaps(points, name)})
      if (!doubt.empty())
        doubts.push_back(doubt);
    return doubts;
  }
} // namespace RollingContact::Profiles
