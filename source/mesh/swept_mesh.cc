#include <rolling_contact/mesh/swept_mesh.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
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

  std::array<double, 2> SectionPlacement::to_section(const Point &place) const
  {
    const double c = std::cos(turn), s = std::sin(turn),
                 y = is_left ? -place[1] : place[1];
    return {
      {contact[0] + c * y + s * place[2], contact[1] - s * y + c * place[2]}};
  }

  std::array<std::array<double, 3>, 3> SectionPlacement::directions() const
  {
    const double c = std::cos(turn), s = std::sin(turn),
                 side = is_left ? -1. : 1.;
    return {{{{0., 0., 1.}}, {{side * c, -side * s, 0.}}, {{s, c, 0.}}}};
  }

  SweptMesh::SweptMesh(const SectionMesh         &section,
                       const SectionPlacement    &placement,
                       const std::vector<double> &ends_x,
                       const double               size)
    : section(section)
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

  bool SweptMesh::is_mirrored() const
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

  std::vector<SweptMesh::Point> SweptMesh::vertices() const
  {
    const std::size_t  n_slices = ends_x.size() - (placement.around ? 1 : 0);
    std::vector<Point> points;
    for (std::size_t i = 0; i < n_slices; ++i)
      for (const SectionPoint &point : section.vertices())
        points.push_back(placement.to_body(ends_x[i], point));
    return points;
  }

  std::array<unsigned int, 8> SweptMesh::corners(const unsigned int cell) const
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

  SectionBoundary SweptMesh::boundary(const unsigned int cell,
                                      const unsigned int face) const
  {
    return face < 2 ? SectionBoundary::none
                    : section.quads()[cell % section.quads().size()]
                        .boundary[face - 2];
  }

  double SweptMesh::x_at(const unsigned int slice, const double local) const
  {
    const double begin = ends_x[slice], end = ends_x[slice + 1],
                 t = mirrored ? 1 - local : local;
    // opposite the contact, downstream of the half of the rim is upstream
    const double period = placement.around ? placement.around->length() : 0.;
    return (1 - t) * begin + t * end -
           (period > 0. && begin + end > period ? period : 0.);
  }

  SweptMesh::Point SweptMesh::chart_point(const unsigned int cell,
                                          const Point       &local) const
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

  SweptMesh::Point SweptMesh::body_point(const unsigned int cell,
                                         const Point       &local) const
  {
    const unsigned int n_quads = section.quads().size();
    return placement.to_body(x_at(cell / n_quads, local[0]),
                             section.at(cell % n_quads, local[1], local[2]));
  }
} // namespace RollingContact
