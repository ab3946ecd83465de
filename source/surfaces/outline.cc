#include <rolling_contact/surfaces/outline.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::Profiles
{
  namespace
  {
    const double same_point = 1e-9; // m

    double distance(const Outline::Point &a, const Outline::Point &b)
    {
      return std::hypot(a[0] - b[0], a[1] - b[1]);
    }

    Outline::Point
    between(const Outline::Point &a, const Outline::Point &b, const double t)
    {
      return {{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}};
    }
  } // namespace

  Outline::Outline(const std::vector<Point> &points)
    : nodes{points.front()}
    , arc{0.}
  {
    for (const Point &point : points)
      if (distance(point, nodes.back()) > same_point)
        {
          arc.push_back(arc.back() + distance(point, nodes.back()));
          nodes.push_back(point);
        }
  }

  Outline::Point Outline::at(const double length) const
  {
    if (length <= 0.)
      return nodes.front();
    if (length >= arc.back())
      return nodes.back();
    const std::size_t k =
      std::upper_bound(arc.begin(), arc.end(), length) - arc.begin();
    return between(nodes[k - 1],
                   nodes[k],
                   (length - arc[k - 1]) / (arc[k] - arc[k - 1]));
  }

  double Outline::nearest(const Point &point) const
  {
    double least = distance(point, nodes.front()), found = 0.;
    for (std::size_t k = 1; k < nodes.size(); ++k)
      {
        const Point &a = nodes[k - 1], &b = nodes[k];
        const double length = arc[k] - arc[k - 1],
                     t      = std::clamp(((point[0] - a[0]) * (b[0] - a[0]) +
                                     (point[1] - a[1]) * (b[1] - a[1])) /
                                      (length * length),
                                    0.,
                                    1.),
                     away   = distance(point, between(a, b, t));
        if (away < least)
          {
            least = away;
            found = arc[k - 1] + t * length;
          }
      }
    return found;
  }

  Outline Outline::part(const double begin, const double end) const
  {
    const double lower = std::min(begin, end), upper = std::max(begin, end);
    std::vector<Point> points{at(lower)};
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (arc[k] > lower && arc[k] < upper)
        points.push_back(nodes[k]);
    points.push_back(at(upper));
    if (begin > end)
      std::reverse(points.begin(), points.end());
    return Outline(points);
  }

  Outline Outline::scaled(const double first, const double second) const
  {
    std::vector<Point> points = nodes;
    for (Point &point : points)
      point = {{first * point[0], second * point[1]}};
    return Outline(points);
  }
} // namespace RollingContact::Profiles
