#include <boost/math/tools/roots.hpp>

#include <rolling_contact/surfaces/profile_curve.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace RollingContact::Profiles
{
  namespace
  {
    /**
     * The length of the arc of a circle between two points with these tangents.
     */
    double arc_between(const CurvePoint &a, const CurvePoint &b)
    {
      const double chord = std::hypot(b.y - a.y, b.z - a.z),
                   half  = (b.angle - a.angle) / 2;
      return std::abs(half) < 1e-8 ? chord : chord * half / std::sin(half);
    }
  } // namespace

  ProfileCurve::ProfileCurve(std::vector<CurvePoint> points)
    : nodes(std::move(points))
    , arc(1, 0.)
  {
    if (nodes.size() < 2)
      throw std::invalid_argument("A profile needs two points or more.");
    for (const CurvePoint &node : nodes)
      tangents.push_back({{std::cos(node.angle), std::sin(node.angle)}});
    for (std::size_t k = 1; k < nodes.size(); ++k)
      {
        arc.push_back(arc.back() + arc_between(nodes[k - 1], nodes[k]));
        if (!(arc[k] > arc[k - 1]))
          throw std::invalid_argument("A point of a profile stands twice.");
      }
  }

  ProfileCurve::Derivatives ProfileCurve::derivatives(const double s) const
  {
    const std::size_t k =
      std::clamp<std::ptrdiff_t>(std::upper_bound(arc.begin(), arc.end(), s) -
                                   arc.begin() - 1,
                                 0,
                                 arc.size() - 2);
    const CurvePoint &a = nodes[k], &b = nodes[k + 1];
    const auto       &from = tangents[k], &to = tangents[k + 1];
    const double      h = arc[k + 1] - arc[k], t = (s - arc[k]) / h;
    // Hermite: value, first and second derivative
    const auto cubic = [&](const double p,
                           const double dp,
                           const double q,
                           const double dq,
                           double      &d,
                           double      &dd) {
      const double c2 = 3 * (q - p) - h * (2 * dp + dq),
                   c3 = 2 * (p - q) + h * (dp + dq);
      d               = dp + t * (2 * c2 + 3 * t * c3) / h;
      dd              = (2 * c2 + 6 * t * c3) / (h * h);
      return p + t * (h * dp + t * (c2 + t * c3));
    };
    Derivatives found;
    found.y = cubic(a.y, from[0], b.y, to[0], found.dy, found.ddy);
    found.z = cubic(a.z, from[1], b.z, to[1], found.dz, found.ddz);
    return found;
  }

  CurvePoint ProfileCurve::at(const double s) const
  {
    const Derivatives d = derivatives(s);
    return {d.y, d.z, std::atan2(d.dz, d.dy)};
  }

  double ProfileCurve::curvature(const double s) const
  {
    const Derivatives d = derivatives(s);
    return (d.dy * d.ddz - d.ddy * d.dz) /
           std::pow(d.dy * d.dy + d.dz * d.dz, 1.5);
  }

  ProfileCurve ProfileCurve::turned(const double angle) const
  {
    const double            c = std::cos(angle), s = std::sin(angle);
    std::vector<CurvePoint> points(nodes);
    for (CurvePoint &point : points)
      point = {c * point.y - s * point.z,
               s * point.y + c * point.z,
               point.angle + angle};
    return ProfileCurve(points);
  }

  ProfileCurve ProfileCurve::shifted(const double dy, const double dz) const
  {
    std::vector<CurvePoint> points(nodes);
    for (CurvePoint &point : points)
      {
        point.y += dy;
        point.z += dz;
      }
    return ProfileCurve(points);
  }

  double ProfileCurve::highest() const
  {
    const std::size_t top =
      std::min_element(nodes.begin(),
                       nodes.end(),
                       [](const CurvePoint &a, const CurvePoint &b) {
                         return a.z < b.z;
                       }) -
      nodes.begin();
    const auto   slope = [&](const double s) { return derivatives(s).dz; };
    const double begin = arc[top == 0 ? 0 : top - 1],
                 end   = arc[std::min(top + 1, arc.size() - 1)];
    if (!(slope(begin) < 0. && slope(end) > 0.))
      return arc[top];
    std::uintmax_t rounds = 100;
    const auto     found  = boost::math::tools::toms748_solve(
      slope, begin, end, boost::math::tools::eps_tolerance<double>(), rounds);
    return (found.first + found.second) / 2;
  }

  ArcLengthAtY::ArcLengthAtY(const ProfileCurve &curve)
    : curve(&curve)
    , first(0)
  {
    const auto  &points = curve.points();
    const double top    = curve.highest();
    std::size_t  middle = std::lower_bound(curve.arc_lengths().begin(),
                                          curve.arc_lengths().end(),
                                          top) -
                         curve.arc_lengths().begin();
    middle = std::min(middle, points.size() - 1);
    first  = middle;
    while (first > 0 && points[first - 1].y < points[first].y)
      --first;
    std::size_t end = middle + 1;
    while (end < points.size() && points[end].y > points[end - 1].y)
      ++end;
    for (std::size_t k = first; k < end; ++k)
      y_of_nodes.push_back(points[k].y);
  }

  double ArcLengthAtY::operator()(const double y) const
  {
    const std::size_t k = std::clamp<std::ptrdiff_t>(
      std::upper_bound(y_of_nodes.begin(), y_of_nodes.end(), y) -
        y_of_nodes.begin() - 1,
      0,
      y_of_nodes.size() - 2);
    const double begin = curve->arc_lengths()[first + k],
                 end   = curve->arc_lengths()[first + k + 1];
    // Newton from the chord: the cubic hardly differs from it
    double s = begin + (end - begin) * (y - y_of_nodes[k]) /
                         (y_of_nodes[k + 1] - y_of_nodes[k]);
    for (unsigned int round = 0; round < 4; ++round)
      {
        const auto   point = curve->derivatives(s);
        const double slope = point.dy / std::hypot(point.dy, point.dz);
        if (slope < 1e-3)
          break;
        const double last = s;
        s                 = std::clamp(s - (point.y - y) / slope, begin, end);
        if (s == last)
          break;
      }
    return s;
  }
} // namespace RollingContact::Profiles
