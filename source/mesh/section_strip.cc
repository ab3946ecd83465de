#include <rolling_contact/mesh/section_strip.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    double distance(const SectionPoint &p, const SectionPoint &q)
    {
      return std::hypot(p[0] - q[0], p[1] - q[1]);
    }
  } // namespace

  std::vector<unsigned int> add_ring_cells(const SectionPoint       &begin,
                                           const SectionPoint       &end,
                                           const SectionMesh::Curve &outside,
                                           const unsigned int        rows,
                                           SectionMesh              &mesh)
  {
    std::vector<unsigned int> quads;
    const auto                line = [&](const unsigned int row) {
      return [=](const double t) {
        return between(between(begin, end, t), outside(t), double(row) / rows);
      };
    };
    for (unsigned int row = 0; row < rows; ++row)
      {
        const auto         below = line(row), above = line(row + 1);
        const unsigned int quad =
          mesh.add({{below(0.), below(1.), above(0.), above(1.)}});
        if (row > 0)
          mesh.set_curve(quad, below(0.), below(1.), below);
        mesh.set_curve(quad, above(0.), above(1.), above);
        quads.push_back(quad);
      }
    return quads;
  }

  void add_strip(const std::vector<double>                       &breaks,
                 const std::vector<SectionPoint>                 &inner,
                 const std::function<SectionPoint(const double)> &surface,
                 const unsigned int                               rows,
                 SectionMesh                                     &mesh)
  {
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      {
        const double       c0 = breaks[i], c1 = breaks[i + 1];
        const SectionPoint p0 = surface(c0), p1 = surface(c1);
        const auto         quads = add_ring_cells(
          inner[i],
          inner[i + 1],
          [surface, c0, c1](const double t) {
            return surface((1 - t) * c0 + t * c1);
          },
          rows,
          mesh);
        mesh.set_boundary(quads.back(), p0, p1, SectionBoundary::contact);
        for (unsigned int row = 0; row < rows; ++row)
          {
            const auto place = [&](const unsigned int end,
                                   const unsigned int level) {
              const double depth = distance(end == 0 ? p0 : p1, inner[i + end]);
              return SectionMesh::ChartPoint{
                {end == 0 ? c0 : c1, -depth * (rows - level) / rows}};
            };
            const auto corner = [&](const unsigned int end,
                                    const unsigned int level) {
              return between(inner[i + end],
                             end == 0 ? p0 : p1,
                             double(level) / rows);
            };
            mesh.set_chart(quads[row],
                           {{corner(0, row),
                             corner(1, row),
                             corner(0, row + 1),
                             corner(1, row + 1)}},
                           {{place(0, row),
                             place(1, row),
                             place(0, row + 1),
                             place(1, row + 1)}});
          }
      }
  }

  unsigned int
  rows_of_strip(const std::vector<double>                       &breaks,
                const std::vector<SectionPoint>                 &inner,
                const std::function<SectionPoint(const double)> &surface,
                const double                                     deepest)
  {
    double depth = 0.;
    for (std::size_t i = 0; i < breaks.size(); ++i)
      depth = std::max(depth, distance(inner[i], surface(breaks[i])));
    return std::max(1., std::ceil(depth / deepest));
  }

  void add_rows(const std::vector<std::vector<SectionPoint>> &rows,
                SectionMesh                                  &mesh)
  {
    for (std::size_t j = 0; j + 1 < rows.size(); ++j)
      for (std::size_t i = 0; i + 1 < rows[j].size(); ++i)
        mesh.add(
          {{rows[j][i], rows[j][i + 1], rows[j + 1][i], rows[j + 1][i + 1]}});
  }

  std::vector<double>
  strip_breaks(const double begin, const double end, const CoarseCells &cells)
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

  std::vector<SectionPoint> equal_parts(const SectionPoint &p,
                                        const SectionPoint &q,
                                        const unsigned int  n)
  {
    std::vector<SectionPoint> points;
    for (unsigned int i = 0; i <= n; ++i)
      points.push_back(between(p, q, double(i) / n));
    return points;
  }

  unsigned int nearest_break(const std::vector<double> &breaks,
                             const double               coordinate)
  {
    unsigned int nearest = 0;
    for (unsigned int i = 0; i < breaks.size(); ++i)
      if (std::abs(breaks[i] - coordinate) <
          std::abs(breaks[nearest] - coordinate))
        nearest = i;
    return nearest;
  }
} // namespace RollingContact
