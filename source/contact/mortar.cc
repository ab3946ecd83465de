#include <rolling_contact/contact/mortar.h>
#include <rolling_contact/contact/overlap.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * The dual function of a corner of a box: on a segment 2 - 3 t and 3 t - 1.
     */
    double dual_shape(const Trace::Cell &cell,
                      const unsigned int corner,
                      const unsigned int n_dimensions,
                      const Point2      &at)
    {
      double value = 1.;
      for (unsigned int d = 0; d < n_dimensions; ++d)
        {
          const double t =
            (at[d] - cell.lower[d]) / (cell.upper[d] - cell.lower[d]);
          value *= (corner >> d) & 1 ? 3 * t - 1 : 2 - 3 * t;
        }
      return value;
    }

    double measure(const Trace::Cell &cell, const unsigned int n_dimensions)
    {
      double value = 1.;
      for (unsigned int d = 0; d < n_dimensions; ++d)
        value *= cell.upper[d] - cell.lower[d];
      return value;
    }

    /**
     * A face's corners and the box around them.
     */
    struct Face
    {
      Face(const SurfaceMesh &surface, const unsigned int face)
      {
        for (unsigned int v = 0; v < 1u << surface.n_dimensions; ++v)
          {
            corners[v] = surface.nodes[surface.faces[face][v]];
            for (unsigned int d = 0; d < surface.n_dimensions; ++d)
              {
                lower[d] = std::min(lower[d], corners[v][d]);
                upper[d] = std::max(upper[d], corners[v][d]);
              }
          }
      }

      bool reaches(const Trace::Cell &cell,
                   const unsigned int n_dimensions) const
      {
        for (unsigned int d = 0; d < n_dimensions; ++d)
          if (upper[d] <= cell.lower[d] || lower[d] >= cell.upper[d])
            return false;
        return true;
      }

      std::array<Point2, 4>   corners{};
      static constexpr double infinity =
        std::numeric_limits<double>::infinity();
      Point2 lower{{infinity, infinity}}, upper{{-infinity, -infinity}};
    };

    /**
     * Number the columns anew, only those that occur.
     */
    void compress(MortarProjection &projection, const std::size_t n_nodes)
    {
      std::vector<int> number(n_nodes, -1);
      for (unsigned int i = 0; i < projection.rows.size(); ++i)
        for (auto &entry : projection.rows[i])
          {
            if (number[entry.first] < 0)
              {
                number[entry.first] = projection.nodes.size();
                projection.nodes.push_back(entry.first);
              }
            entry.first = number[entry.first];
          }
    }

    double second_moment(const Trace           &interface,
                         const SurfaceMesh     &surface,
                         const SparseRows::Row &row,
                         const unsigned int     node,
                         const unsigned int     d)
    {
      double moment = 0.;
      for (const auto &entry : row)
        moment +=
          entry.second *
          std::pow(surface.nodes[entry.first][d] - interface.nodes[node][d], 2);
      return moment;
    }

    /**
     * alpha_d >= 0 for which the differences of a row with its neighbours along
     * d, alpha_d (P_i+1 - 2 P_i + P_i-1), take its second moment away, in the
     * mean over nodes inside.
     */
    double smoothing(const Trace            &interface,
                     const SurfaceMesh      &surface,
                     const MortarProjection &projection,
                     const unsigned int      d)
    {
      const std::vector<bool> border = interface.border_nodes();
      double                  sum    = 0.;
      unsigned int            n      = 0;
      for (unsigned int i = 0; i < border.size(); ++i)
        if (!border[i])
          {
            sum += second_moment(interface, surface, projection.rows[i], i, d);
            ++n;
          }
      const Trace::Cell &cell = interface.cells[0];
      const double       size = cell.upper[d] - cell.lower[d];
      return n == 0 ? 0. : std::max(0., -sum / n / (2 * size * size));
    }

    /**
     * P + D^-1 L P with L symmetric and L 1 = 0: the differences above, cell by
     * cell.
     */
    void smooth(const Trace               &interface,
                const std::vector<double> &areas,
                const unsigned int         d,
                const double               alpha,
                SparseRows                &rows)
    {
      const SparseRows   old       = rows;
      const unsigned int n_corners = 1 << interface.n_dimensions;
      for (const Trace::Cell &cell : interface.cells)
        for (unsigned int v = 0; v < n_corners; ++v)
          {
            const unsigned int i = cell.corners[v][0].first,
                               j = cell.corners[v ^ (1 << d)][0].first;
            const double weight  = alpha *
                                  measure(cell, interface.n_dimensions) /
                                  (n_corners / 2) / areas[i];
            for (const auto &entry : old[j])
              rows.add(i, entry.first, weight * entry.second);
            for (const auto &entry : old[i])
              rows.add(i, entry.first, -weight * entry.second);
          }
    }
  } // namespace

  MortarProjection mortar_projection(const Trace       &interface,
                                     const SurfaceMesh &surface)
  {
    const unsigned int n_dimensions = interface.n_dimensions,
                       n_corners    = 1 << n_dimensions;
    std::vector<Face> faces;
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      faces.emplace_back(surface, f);
    MortarProjection    projection{SparseRows(interface.nodes.size()), {}, {}};
    std::vector<double> areas(interface.nodes.size(), 0.);
    for (const Trace::Cell &cell : interface.cells)
      {
        const double area = measure(cell, n_dimensions);
        double       sum  = 0.;
        for (unsigned int a = 0; a < n_corners; ++a)
          areas[cell.corners[a][0].first] += area / n_corners;
        for (unsigned int f = 0; f < faces.size(); ++f)
          if (faces[f].reaches(cell, n_dimensions))
            for (const OverlapPoint &point :
                 overlap_points(cell, faces[f].corners, n_dimensions))
              {
                sum += point.weight;
                for (unsigned int a = 0; a < n_corners; ++a)
                  for (unsigned int b = 0; b < n_corners; ++b)
                    projection.rows.add(
                      cell.corners[a][0].first,
                      surface.faces[f][b],
                      point.weight * point.shapes[b] *
                        dual_shape(cell, a, n_dimensions, point.at));
              }
        projection.covered.push_back(sum / area);
      }
    for (unsigned int i = 0; i < areas.size(); ++i)
      for (auto &entry : projection.rows[i])
        entry.second /= areas[i];
    for (unsigned int d = 0; d < n_dimensions; ++d)
      smooth(interface,
             areas,
             d,
             smoothing(interface, surface, projection, d),
             projection.rows);
    compress(projection, surface.nodes.size());
    return projection;
  }
} // namespace RollingContact
