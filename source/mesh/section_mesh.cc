#include <rolling_contact/mesh/section_mesh.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    const double same_point = 1e-9; // m

    /// corners of the edges, begin and end by ascending a or b
    constexpr unsigned int corner_of_edge[4][2] = {{0, 2},
                                                   {1, 3},
                                                   {0, 1},
                                                   {2, 3}};

    bool coincide(const SectionPoint &p, const SectionPoint &q)
    {
      return std::hypot(p[0] - q[0], p[1] - q[1]) < same_point;
    }

    SectionPoint
    straight(const SectionPoint &p, const SectionPoint &q, const double t)
    {
      SectionPoint result;
      for (unsigned int d = 0; d < 3; ++d)
        result[d] = (1 - t) * p[d] + t * q[d];
      return result;
    }

    /**
     * Sine of the angle at @p corner from the edge to @p next to that to
     * @p previous.
     */
    double sine(const SectionPoint &corner,
                const SectionPoint &next,
                const SectionPoint &previous)
    {
      const double ax = next[0] - corner[0], ay = next[1] - corner[1],
                   bx = previous[0] - corner[0], by = previous[1] - corner[1];
      return (ax * by - ay * bx) / (std::hypot(ax, ay) * std::hypot(bx, by));
    }
  } // namespace

  SectionMesh::SectionMesh(
    const std::vector<SectionPoint>                &points,
    const std::vector<std::array<unsigned int, 4>> &corners)
    : points(points)
  {
    for (const auto &quad : corners)
      cells.push_back({quad});
  }

  std::array<unsigned int, 2>
  SectionMesh::ends_of_edge(const unsigned int quad,
                            const unsigned int edge) const
  {
    const auto &corners = cells[quad].corners;
    return {
      {corners[corner_of_edge[edge][0]], corners[corner_of_edge[edge][1]]}};
  }

  unsigned int SectionMesh::vertex(const SectionPoint &point)
  {
    for (unsigned int i = 0; i < points.size(); ++i)
      if (coincide(points[i], point))
        return i;
    points.push_back(point);
    return points.size() - 1;
  }

  unsigned int SectionMesh::add(const std::array<SectionPoint, 4> &corners)
  {
    std::array<SectionPoint, 4> c = corners;
    const double area             = (c[3][0] - c[0][0]) * (c[2][1] - c[1][1]) -
                        (c[3][1] - c[0][1]) * (c[2][0] - c[1][0]);
    if (area < 0.)
      {
        std::swap(c[0], c[1]);
        std::swap(c[2], c[3]);
      }
    Quad quad;
    for (unsigned int v = 0; v < 4; ++v)
      quad.corners[v] = vertex(c[v]);
    cells.push_back(quad);
    return cells.size() - 1;
  }

  unsigned int SectionMesh::edge_between(const unsigned int  quad,
                                         const SectionPoint &begin,
                                         const SectionPoint &end,
                                         bool               &reversed) const
  {
    for (unsigned int e = 0; e < 4; ++e)
      {
        const auto          ends = ends_of_edge(quad, e);
        const SectionPoint &p = points[ends[0]], &q = points[ends[1]];
        reversed = coincide(p, end) && coincide(q, begin);
        if (reversed || (coincide(p, begin) && coincide(q, end)))
          return e;
      }
    throw std::logic_error("A section has no such edge.");
  }

  void SectionMesh::set_curve(const unsigned int  quad,
                              const SectionPoint &begin,
                              const SectionPoint &end,
                              const Curve        &curve)
  {
    bool               reversed;
    const unsigned int edge = edge_between(quad, begin, end, reversed);
    cells[quad].curves[edge] =
      reversed ? Curve([curve](const double t) { return curve(1 - t); })
               : curve;
  }

  void SectionMesh::set_boundary(const unsigned int    quad,
                                 const SectionPoint   &begin,
                                 const SectionPoint   &end,
                                 const SectionBoundary boundary)
  {
    bool reversed;
    cells[quad].boundary[edge_between(quad, begin, end, reversed)] = boundary;
  }

  void SectionMesh::set_chart(const unsigned int                 quad,
                              const std::array<SectionPoint, 4> &corners,
                              const std::array<ChartPoint, 4>   &chart)
  {
    const bool turned = !coincide(points[cells[quad].corners[0]], corners[0]);
    cells[quad].chart = chart;
    if (turned)
      {
        std::swap((*cells[quad].chart)[0], (*cells[quad].chart)[1]);
        std::swap((*cells[quad].chart)[2], (*cells[quad].chart)[3]);
      }
  }

  SectionPoint
  SectionMesh::at(const unsigned int quad, const double a, const double b) const
  {
    const Quad                 &cell = cells[quad];
    std::array<SectionPoint, 4> c;
    for (unsigned int v = 0; v < 4; ++v)
      c[v] = points[cell.corners[v]];
    SectionPoint result =
      straight(straight(c[0], c[1], a), straight(c[2], c[3], a), b);
    const std::array<double, 4> weight{{1 - a, a, 1 - b, b}};
    for (unsigned int e = 0; e < 4; ++e)
      if (cell.curves[e] && weight[e] != 0.)
        {
          const double       t     = e < 2 ? b : a;
          const SectionPoint on    = cell.curves[e](t),
                             chord = straight(c[corner_of_edge[e][0]],
                                              c[corner_of_edge[e][1]],
                                              t);
          for (unsigned int d = 0; d < 3; ++d)
            result[d] += weight[e] * (on[d] - chord[d]);
        }
    return result;
  }

  SectionMesh SectionMesh::mirrored() const
  {
    const auto image = [](const SectionPoint &point) {
      return SectionPoint{{-point[0], point[1], point[2]}};
    };
    SectionMesh result;
    for (unsigned int quad = 0; quad < cells.size(); ++quad)
      {
        std::array<SectionPoint, 4> corners;
        for (unsigned int v = 0; v < 4; ++v)
          corners[v] = image(points[cells[quad].corners[v]]);
        result.add(corners);
        for (unsigned int edge = 0; edge < 4; ++edge)
          {
            const auto ends  = ends_of_edge(quad, edge);
            const auto begin = image(points[ends[0]]),
                       end   = image(points[ends[1]]);
            result.set_boundary(quad, begin, end, cells[quad].boundary[edge]);
            if (const Curve &curve = cells[quad].curves[edge])
              result.set_curve(quad, begin, end, [=](const double t) {
                return image(curve(t));
              });
          }
      }
    return result;
  }

  double SectionMesh::least_quality(const unsigned int parts) const
  {
    double least = 1.;
    for (unsigned int quad = 0; quad < cells.size(); ++quad)
      for (unsigned int i = 0; i < parts; ++i)
        for (unsigned int j = 0; j < parts; ++j)
          {
            const auto corner = [&](const unsigned int di,
                                    const unsigned int dj) {
              return at(quad, double(i + di) / parts, double(j + dj) / parts);
            };
            const std::array<SectionPoint, 4> around{
              {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}};
            for (unsigned int v = 0; v < 4; ++v)
              least = std::min(least,
                               sine(around[v],
                                    around[(v + 1) % 4],
                                    around[(v + 3) % 4]));
          }
    return least;
  }
} // namespace RollingContact
