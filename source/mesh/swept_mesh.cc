#include <rolling_contact/mesh/swept_mesh.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace RollingContact
{
  namespace
  {
    using Edge = std::array<unsigned int, 2>; ///< vertices, ascending

    /// corners of the edges, begin and end by ascending a or b
    constexpr unsigned int corner_of_edge[4][2] = {{0, 2},
                                                   {1, 3},
                                                   {0, 1},
                                                   {2, 3}};



    Edge
    edge_of(const SectionMesh::Quad &quad, const unsigned int e)
    {
      const unsigned int p = quad.corners[corner_of_edge[e][0]],
                         q = quad.corners[corner_of_edge[e][1]];
      return {{std::min(p, q), std::max(p, q)}};
    }



    bool
    ascends(const SectionMesh::Quad &quad, const unsigned int e)
    {
      return quad.corners[corner_of_edge[e][0]] <
             quad.corners[corner_of_edge[e][1]];
    }



    /**
     * Directions of all edges, whether from the vertex with the smaller number,
     * such that opposite edges of each quadrilateral point the same way.
     */
    std::map<Edge, bool>
    directions(const SectionMesh &mesh)
    {
      std::map<Edge, std::vector<std::pair<unsigned int, unsigned int>>> users;
      for (unsigned int q = 0; q < mesh.quads().size(); ++q)
        for (unsigned int e = 0; e < 4; ++e)
          users[edge_of(mesh.quads()[q], e)].push_back({q, e});
      std::map<Edge, bool> result;
      for (const auto &start : users)
        {
          std::vector<Edge> open;
          if (result.emplace(start.first, true).second)
            open.push_back(start.first);
          while (!open.empty())
            {
              const Edge edge = open.back();
              open.pop_back();
              for (const auto &[q, e] : users.at(edge))
                {
                  const auto &quad    = mesh.quads()[q];
                  const Edge  other   = edge_of(quad, e ^ 1u);
                  const bool forwards = (result.at(edge) == ascends(quad, e)) ==
                                        ascends(quad, e ^ 1u);
                  const auto [found, is_new] = result.emplace(other, forwards);
                  if (is_new)
                    open.push_back(other);
                  else if (found->second != forwards)
                    throw std::logic_error("A section is no plane surface.");
                }
            }
        }
      return result;
    }



    /**
     * The same quadrilaterals, turned so that each edge has the same direction
     * in both that share it, as p4est wants of the faces swept from them.
     */
    SectionMesh
    consistently_ordered(const SectionMesh &mesh)
    {
      const auto  way = directions(mesh);
      SectionMesh result;
      for (const SectionMesh::Quad &quad : mesh.quads())
        {
          const auto reversed = [&](const unsigned int e) {
            return way.at(edge_of(quad, e)) != ascends(quad, e);
          };
          const bool b_reversed = reversed(0), a_reversed = reversed(2),
                     transposed = a_reversed != b_reversed;
          std::array<SectionPoint, 4>            corners;
          std::array<SectionMesh::ChartPoint, 4> chart{};
          for (unsigned int v = 0; v < 4; ++v)
            {
              unsigned int a = v & 1, b = v >> 1;
              if (transposed)
                std::swap(a, b);
              const unsigned int old =
                (a_reversed ? 1 - a : a) + 2 * (b_reversed ? 1 - b : b);
              corners[v] = mesh.vertices()[quad.corners[old]];
              if (quad.chart)
                chart[v] = (*quad.chart)[old];
            }
          const unsigned int added = result.add(corners);
          if (quad.chart)
            result.set_chart(added, corners, chart);
          for (unsigned int e = 0; e < 4; ++e)
            {
              const SectionPoint
                &begin = mesh.vertices()[quad.corners[corner_of_edge[e][0]]],
                &end   = mesh.vertices()[quad.corners[corner_of_edge[e][1]]];
              if (quad.curves[e])
                result.set_curve(added, begin, end, quad.curves[e]);
              result.set_boundary(added, begin, end, quad.boundary[e]);
            }
        }
      return result;
    }
  } // namespace



  SectionPlacement::Point
  SectionPlacement::to_body(const double x, const SectionPoint &point) const
  {
    double along = x, outwards = point[1];
    if (around)
      {
        const double angle = around->angle_on(x, point[2]);
        along              = point[1] * std::sin(angle);
        outwards           = point[1] * std::cos(angle);
      }
    const double c = std::cos(turn), s = std::sin(turn),
                 across = point[0] - contact[0];
    outwards -= contact[1];
    const double y = c * across - s * outwards;
    return {{along, is_left ? -y : y, s * across + c * outwards}};
  }



  SweptMesh::SweptMesh(const SectionMesh         &given,
                       const SectionPlacement    &placement,
                       const std::vector<double> &ends_x,
                       const double               size)
    : section(consistently_ordered(given))
    , placement(placement)
    , ends_x(ends_x)
    , coarse_size(size)
  {
    for (const SectionMesh::Quad &quad : section.quads())
      {
        chart.emplace_back();
        for (unsigned int v = 0; v < 4; ++v)
          {
            if (quad.chart)
              {
                chart.back()[v] = (*quad.chart)[v];
                if (placement.is_left)
                  chart.back()[v][0] *= -1;
                continue;
              }
            const Point at =
              placement.to_body(0., section.vertices()[quad.corners[v]]);
            chart.back()[v] = {{at[1], std::min(0., at[2])}};
          }
      }
    mirrored = is_mirrored();
  }



  bool
  SweptMesh::is_mirrored() const
  {
    const SectionPoint begin  = section.at(0, 0., 0.5),
                       end    = section.at(0, 1., 0.5),
                       bottom = section.at(0, 0.5, 0.),
                       top    = section.at(0, 0.5, 1.);
    const Point p0            = placement.to_body(0., begin),
                p1            = placement.to_body(0., end),
                q0            = placement.to_body(0., bottom),
                q1            = placement.to_body(0., top);
    return (p1[1] - p0[1]) * (q1[2] - q0[2]) -
             (p1[2] - p0[2]) * (q1[1] - q0[1]) <
           0.;
  }



  std::vector<SweptMesh::Point>
  SweptMesh::vertices() const
  {
    const std::size_t  n_slices = ends_x.size() - (placement.around ? 1 : 0);
    std::vector<Point> points;
    for (std::size_t i = 0; i < n_slices; ++i)
      for (const SectionPoint &point : section.vertices())
        points.push_back(placement.to_body(ends_x[i], point));
    return points;
  }



  std::array<unsigned int, 8>
  SweptMesh::corners(const unsigned int cell) const
  {
    const unsigned int n_points = section.vertices().size(),
                       n_quads = section.quads().size(), slice = cell / n_quads,
                       n_slices = ends_x.size() - (placement.around ? 1 : 0);
    std::array<unsigned int, 8> result;
    for (unsigned int v = 0; v < 8; ++v)
      {
        const bool         upper = ((v & 1) != 0) != mirrored;
        const unsigned int at    = (slice + (upper ? 1 : 0)) % n_slices;
        result[v] =
          at * n_points + section.quads()[cell % n_quads].corners[v >> 1];
      }
    return result;
  }



  SectionBoundary
  SweptMesh::boundary(const unsigned int cell, const unsigned int face) const
  {
    return face < 2 ? SectionBoundary::none
                    : section.quads()[cell % section.quads().size()]
                        .boundary[face - 2];
  }



  double
  SweptMesh::x_at(const unsigned int slice, const double local) const
  {
    const double begin = ends_x[slice], end = ends_x[slice + 1],
                 t = mirrored ? 1 - local : local;
    // opposite the contact, downstream of the half of the rim is upstream
    const double period = placement.around ? placement.around->length() : 0.;
    return (1 - t) * begin + t * end -
           (period > 0. && begin + end > period ? period : 0.);
  }



  SweptMesh::Point
  SweptMesh::chart_point(const unsigned int cell, const Point &local) const
  {
    const unsigned int quad = cell % section.quads().size();
    Point result{{x_at(cell / section.quads().size(), local[0]), 0., 0.}};
    for (unsigned int d = 0; d < 2; ++d)
      {
        const auto along_a = [&](const unsigned int row) {
          return (1 - local[1]) * chart[quad][2 * row][d] +
                 local[1] * chart[quad][2 * row + 1][d];
        };
        result[1 + d] = (1 - local[2]) * along_a(0) + local[2] * along_a(1);
      }
    return result;
  }



  SweptMesh::Point
  SweptMesh::body_point(const unsigned int cell, const Point &local) const
  {
    const unsigned int n_quads = section.quads().size();
    return placement.to_body(x_at(cell / n_quads, local[0]),
                             section.at(cell % n_quads, local[1], local[2]));
  }
} // namespace RollingContact
