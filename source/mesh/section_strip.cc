#include <rolling_contact/mesh/section_strip.h>

#include <cmath>

namespace RollingContact
{
  void
  add_strip(const std::vector<double>                       &breaks,
            const std::vector<SectionPoint>                 &inner,
            const std::function<SectionPoint(const double)> &surface,
            SectionMesh                                     &mesh)
  {
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      {
        const double       c0 = breaks[i], c1 = breaks[i + 1];
        const SectionPoint p0 = surface(c0), p1 = surface(c1);
        const auto         depth = [](const SectionPoint &p,
                              const SectionPoint &q) {
          return -std::hypot(p[0] - q[0], p[1] - q[1]);
        };
        const std::array<SectionPoint, 4> corners{
          {inner[i], inner[i + 1], p0, p1}};
        const unsigned int quad = mesh.add(corners);
        mesh.set_curve(quad, p0, p1, [surface, c0, c1](const double t) {
          return surface((1 - t) * c0 + t * c1);
        });
        mesh.set_boundary(quad, p0, p1, SectionBoundary::contact);
        mesh.set_chart(quad,
                       corners,
                       {{{{c0, depth(p0, inner[i])}},
                         {{c1, depth(p1, inner[i + 1])}},
                         {{c0, 0.}},
                         {{c1, 0.}}}});
      }
  }



  void
  add_rows(const std::vector<std::vector<SectionPoint>> &rows,
           SectionMesh                                  &mesh)
  {
    for (std::size_t j = 0; j + 1 < rows.size(); ++j)
      for (std::size_t i = 0; i + 1 < rows[j].size(); ++i)
        mesh.add(
          {{rows[j][i], rows[j][i + 1], rows[j + 1][i], rows[j + 1][i + 1]}});
  }



  std::vector<double>
  strip_breaks(const double       begin,
               const double       end,
               const CoarseCells &cells)
  {
    const double        size = cells.size;
    std::vector<double> breaks{begin};
    for (double k = std::ceil(begin / size); k * size < end; ++k)
      if (k * size > begin + size / 2 && k * size < end - size / 2)
        breaks.push_back(k * size);
    breaks.push_back(end);
    return breaks;
  }



  SectionPoint
  between(const SectionPoint &p, const SectionPoint &q, const double t)
  {
    SectionPoint result;
    for (unsigned int d = 0; d < 3; ++d)
      result[d] = (1 - t) * p[d] + t * q[d];
    return result;
  }



  std::vector<SectionPoint>
  equal_parts(const SectionPoint &p, const SectionPoint &q, const unsigned int n)
  {
    std::vector<SectionPoint> points;
    for (unsigned int i = 0; i <= n; ++i)
      points.push_back(between(p, q, double(i) / n));
    return points;
  }



  unsigned int
  nearest_break(const std::vector<double> &breaks, const double coordinate)
  {
    unsigned int nearest = 0;
    for (unsigned int i = 0; i < breaks.size(); ++i)
      if (std::abs(breaks[i] - coordinate) <
          std::abs(breaks[nearest] - coordinate))
        nearest = i;
    return nearest;
  }
} // namespace RollingContact
