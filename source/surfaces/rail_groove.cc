#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/surfaces/rail_groove.h>

#include <algorithm>
#include <limits>

namespace RollingContact::Profiles
{
  namespace
  {
    const double least_depth = 15e-3; // m; flanges are 22 to 30 mm high

    const double least_head = 25e-3; // m across; keepers have 10 to 25 mm

    using Iterator = std::vector<MeasuredPoint>::const_iterator;

    /** From the least to the largest y of the points above a depth. */
    double width_above(const Iterator begin, const Iterator end, const double z)
    {
      const double infinity = std::numeric_limits<double>::infinity();
      double       least = infinity, largest = -infinity;
      for (Iterator at = begin; at != end; ++at)
        if (at->z < z)
          {
            least   = std::min(least, at->y);
            largest = std::max(largest, at->y);
          }
      return std::max(0., largest - least);
    }
  } // namespace

  std::optional<RailGroove> groove_of(const std::vector<MeasuredPoint> &points)
  {
    const std::size_t   n = points.size();
    std::vector<double> top_behind(n); // least z from a point on
    for (std::size_t k = n; k-- > 0;)
      top_behind[k] =
        k + 1 < n ? std::min(points[k].z, top_behind[k + 1]) : points[k].z;
    RailGroove found{0., 0., 0, true};
    double     top_before = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k)
      {
        top_before         = std::min(top_before, points[k].z);
        const double depth = points[k].z - std::max(top_before, top_behind[k]);
        if (depth > found.depth)
          found = {depth, points[k].y, k, true};
      }
    if (found.depth < least_depth)
      return {};
    const double half   = points[found.deepest].z - found.depth / 2;
    const auto   bottom = points.begin() + found.deepest;
    const double left   = width_above(points.begin(), bottom, half),
                 right  = width_above(bottom, points.end(), half);
    if (std::max(left, right) < least_head)
      return {};
    found.is_right = right > left;
    return found;
  }

  void leave_out_keeper(std::vector<MeasuredPoint> &points,
                        const std::string          &name)
  {
    const auto groove = groove_of(points);
    if (!groove)
      return;
    if (!groove->is_right)
      throw InputError(
        name + ": the rail has a groove " +
        significant(1e3 * groove->depth, 3) +
        " mm deep at y = " + significant(1e3 * groove->floor_y, 3) +
        " mm, at larger y than its head; y is towards the field side of the "
        "right-hand rail here, and a groove is on the gauge side: set "
        "Profiles/Rail mirror = y.");
    points.erase(points.begin(), points.begin() + groove->deepest);
    if (groove_of(points))
      throw InputError(
        name + ": there are two grooves, as in the profile of a grooved "
               "rail that is upside down; z is downwards here: set "
               "Profiles/Rail mirror = z.");
  }
} // namespace RollingContact::Profiles
