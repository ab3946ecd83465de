#include <boost/math/quadrature/gauss.hpp>

#include <rolling_contact/contact/overlap.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    struct GaussRule
    {
      std::vector<double> points, weights; ///< on [0, 1]
    };

    template <unsigned int n>
    GaussRule gauss_rule()
    {
      using Half = boost::math::quadrature::gauss<double, n>;
      GaussRule rule;
      for (const double sign : {-1., 1.})
        for (std::size_t k = 0; k < Half::abscissa().size(); ++k)
          if (sign > 0. || Half::abscissa()[k] != 0.)
            {
              rule.points.push_back((1 + sign * Half::abscissa()[k]) / 2);
              rule.weights.push_back(Half::weights()[k] / 2);
            }
      return rule;
    }

    double cross(const Point2 &a, const Point2 &b, const Point2 &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /**
     * The corners of a quadrilateral in the order of its boundary, to the left.
     */
    std::vector<Point2> outline(const std::array<Point2, 4> &face)
    {
      std::vector<Point2> polygon{face[0], face[1], face[3], face[2]};
      const double        twice_area =
        cross(face[0], face[1], face[3]) + cross(face[0], face[3], face[2]);
      if (twice_area < 0.)
        std::reverse(polygon.begin(), polygon.end());
      return polygon;
    }

    /**
     * The part of a convex polygon with sign (coordinate d - limit) >= 0
     * (Sutherland and Hodgman 1974).
     */
    std::vector<Point2> cut(const std::vector<Point2> &polygon,
                            const unsigned int         d,
                            const double               limit,
                            const double               sign)
    {
      std::vector<Point2> part;
      for (std::size_t k = 0; k < polygon.size(); ++k)
        {
          const Point2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
          const double  at_a = sign * (a[d] - limit),
                       at_b  = sign * (b[d] - limit);
          if (at_a >= 0.)
            part.push_back(a);
          if ((at_a < 0.) == (at_b < 0.))
            continue;
          const double s = at_a / (at_a - at_b);
          Point2       between{{a[0] + s * (b[0] - a[0]), //
                                a[1] + s * (b[1] - a[1])}};
          between[d] = limit;
          part.push_back(between);
        }
      return part;
    }

    std::array<double, 4> bilinear(const double s, const double t)
    {
      return {{(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t}};
    }

    /**
     * Shape functions of a quadrilateral at a point of it: the bilinear map is
     * inverted by Newton's method.
     */
    std::array<double, 4> shapes_at(const std::array<Point2, 4> &face,
                                    const Point2                &at)
    {
      double s = 0.5, t = 0.5;
      for (unsigned int step = 0; step < 20; ++step)
        {
          const auto shapes = bilinear(s, t);
          double     miss[2], along_s[2], along_t[2];
          for (unsigned int d = 0; d < 2; ++d)
            {
              miss[d] = at[d];
              for (unsigned int v = 0; v < 4; ++v)
                miss[d] -= shapes[v] * face[v][d];
              along_s[d] = (1 - t) * (face[1][d] - face[0][d]) +
                           t * (face[3][d] - face[2][d]);
              along_t[d] = (1 - s) * (face[2][d] - face[0][d]) +
                           s * (face[3][d] - face[1][d]);
            }
          const double determinant =
            along_s[0] * along_t[1] - along_s[1] * along_t[0];
          const double change_s =
                         (miss[0] * along_t[1] - miss[1] * along_t[0]) /
                         determinant,
                       change_t =
                         (along_s[0] * miss[1] - along_s[1] * miss[0]) /
                         determinant;
          s += change_s;
          t += change_t;
          if (std::abs(change_s) + std::abs(change_t) < 1e-14)
            break;
        }
      return bilinear(s, t);
    }

    bool is_parallelogram(const std::array<Point2, 4> &face)
    {
      double difference = 0., size = 0.;
      for (unsigned int d = 0; d < 2; ++d)
        {
          difference +=
            std::abs(face[0][d] - face[1][d] - face[2][d] + face[3][d]);
          size += std::abs(face[3][d] - face[0][d]) +
                  std::abs(face[2][d] - face[1][d]);
        }
      return difference < 1e-9 * size;
    }

    /**
     * A rule on the triangle: the square's with one side drawn together.
     */
    void add_triangle(const Point2                &a,
                      const Point2                &b,
                      const Point2                &c,
                      const std::array<Point2, 4> &face,
                      std::vector<OverlapPoint>   &points)
    {
      static const GaussRule few = gauss_rule<3>(), many = gauss_rule<8>();
      const GaussRule       &rule       = is_parallelogram(face) ? few : many;
      const double           twice_area = cross(a, b, c);
      for (unsigned int i = 0; i < rule.points.size(); ++i)
        for (unsigned int j = 0; j < rule.points.size(); ++j)
          {
            const double s = rule.points[i], t = s * rule.points[j];
            OverlapPoint point;
            for (unsigned int d = 0; d < 2; ++d)
              point.at[d] = a[d] + (s - t) * (b[d] - a[d]) + t * (c[d] - a[d]);
            point.weight = rule.weights[i] * rule.weights[j] * s * twice_area;
            point.shapes = shapes_at(face, point.at);
            points.push_back(point);
          }
    }

    std::vector<OverlapPoint> segment_points(const Trace::Cell           &cell,
                                             const std::array<Point2, 4> &face)
    {
      static const GaussRule rule = gauss_rule<2>();
      const double           left = face[0][0], right = face[1][0],
                   begin = std::max(cell.lower[0], std::min(left, right)),
                   end   = std::min(cell.upper[0], std::max(left, right));
      std::vector<OverlapPoint> points;
      for (unsigned int i = 0; begin < end && i < 2; ++i)
        {
          const double x = begin + rule.points[i] * (end - begin),
                       s = (x - left) / (right - left);
          points.push_back(
            {{{x, 0.}}, rule.weights[i] * (end - begin), {{1 - s, s, 0., 0.}}});
        }
      return points;
    }
  } // namespace

  bool is_convex(const std::array<Point2, 4> &face)
  {
    const std::vector<Point2> polygon = outline(face);
    for (unsigned int k = 0; k < 4; ++k)
      if (cross(polygon[k], polygon[(k + 1) % 4], polygon[(k + 2) % 4]) <= 0.)
        return false;
    return true;
  }

  std::vector<OverlapPoint> overlap_points(const Trace::Cell           &cell,
                                           const std::array<Point2, 4> &face,
                                           const unsigned int n_dimensions)
  {
    if (n_dimensions == 1)
      return segment_points(cell, face);
    std::vector<Point2> polygon = outline(face);
    for (unsigned int d = 0; d < 2; ++d)
      {
        polygon = cut(polygon, d, cell.lower[d], 1.);
        polygon = cut(polygon, d, cell.upper[d], -1.);
      }
    std::vector<OverlapPoint> points;
    for (std::size_t k = 2; k < polygon.size(); ++k)
      add_triangle(polygon[0], polygon[k - 1], polygon[k], face, points);
    return points;
  }
} // namespace RollingContact
