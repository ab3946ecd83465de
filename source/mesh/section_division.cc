#include <rolling_contact/mesh/section_mesh.h>
#include <rolling_contact/mesh/surface_chart.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace RollingContact
{
  namespace
  {
    using Edge = std::pair<unsigned int, unsigned int>; ///< ends, ascending

    Edge edge_of(const SectionMesh &section,
                 const unsigned int quad,
                 const unsigned int edge)
    {
      const auto ends = section.ends_of_edge(quad, edge);
      return std::minmax(ends[0], ends[1]);
    }

    double length_of(const SectionMesh &section,
                     const unsigned int quad,
                     const unsigned int edge)
    {
      const unsigned int n_parts = 8; // of a curve
      const auto         at      = [&](const double t) {
        return edge < 2 ? section.at(quad, edge, t)
                                     : section.at(quad, t, edge - 2);
      };
      double length = 0.;
      for (unsigned int i = 0; i < n_parts; ++i)
        {
          const SectionPoint p = at(double(i) / n_parts),
                             q = at(double(i + 1) / n_parts);
          length += std::hypot(q[0] - p[0], q[1] - p[1]);
        }
      return length;
    }

    /**
     * Into how many parts each edge is divided: opposite ones into as many.
     */
    std::map<Edge, unsigned int> parts_of_edges(const SectionMesh &section,
                                                const double       longest)
    {
      std::map<Edge, unsigned int> parts;
      for (unsigned int quad = 0; quad < section.quads().size(); ++quad)
        for (unsigned int edge = 0; edge < 4; ++edge)
          {
            unsigned int &n = parts[edge_of(section, quad, edge)];
            n               = std::max(n,
                         fewest_parts(length_of(section, quad, edge), longest));
          }
      for (bool changed = true; changed;)
        {
          changed = false;
          for (unsigned int quad = 0; quad < section.quads().size(); ++quad)
            for (const unsigned int edge : {0, 2})
              {
                unsigned int &one   = parts[edge_of(section, quad, edge)],
                             &other = parts[edge_of(section, quad, edge + 1)];
                changed             = changed || one != other;
                one = other = std::max(one, other);
              }
        }
      return parts;
    }
  } // namespace

  SectionMesh SectionMesh::divided(const double longest) const
  {
    if (std::isinf(longest))
      return *this;
    const auto  parts = parts_of_edges(*this, longest);
    SectionMesh fine;
    for (unsigned int quad = 0; quad < cells.size(); ++quad)
      {
        const unsigned int n_a = parts.at(edge_of(*this, quad, 2)),
                           n_b = parts.at(edge_of(*this, quad, 0));
        const auto corner = [&](const unsigned int i, const unsigned int j) {
          return at(quad, double(i) / n_a, double(j) / n_b);
        };
        const auto &edges = cells[quad].boundary;
        for (unsigned int i = 0; i < n_a; ++i)
          for (unsigned int j = 0; j < n_b; ++j)
            {
              auto &boundary = fine
                                 .cells[fine.add({{corner(i, j),
                                                   corner(i + 1, j),
                                                   corner(i, j + 1),
                                                   corner(i + 1, j + 1)}})]
                                 .boundary;
              if (i == 0)
                boundary[0] = edges[0];
              if (i + 1 == n_a)
                boundary[1] = edges[1];
              if (j == 0)
                boundary[2] = edges[2];
              if (j + 1 == n_b)
                boundary[3] = edges[3];
            }
      }
    return fine;
  }
} // namespace RollingContact
