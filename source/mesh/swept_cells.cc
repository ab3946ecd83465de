#include <rolling_contact/mesh/body_mesh.h>
#include <rolling_contact/mesh/cell_count.h>
#include <rolling_contact/mesh/swept_cells.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** A cell as a part of its coarse cell's unit cube. */
    struct PartOfCoarseCell
    {
      unsigned int          coarse_cell;
      std::array<double, 3> lower{};
      double                size = 1.;

      std::array<double, 3> corner(const unsigned int v) const
      {
        std::array<double, 3> local = lower;
        for (unsigned int d = 0; d < 3; ++d)
          local[d] += ((v >> d) & 1) * size;
        return local;
      }
    };

    PartOfCoarseCell part_of(const SweptCellIterator &cell)
    {
      // the id's coarse cell is p4est's, in an order of its own
      SweptCellIterator coarse = cell;
      while (coarse->level() > 0)
        coarse = coarse->parent();
      PartOfCoarseCell part;
      part.coarse_cell = coarse->index();
      const CellId id  = cell->id();
      for (const unsigned int child : id.get_child_indices())
        {
          part.size /= 2;
          for (unsigned int d = 0; d < 3; ++d)
            part.lower[d] += ((child >> d) & 1) * part.size;
        }
      return part;
    }

    Point<3> as_point(const SweptMesh::Point &point)
    {
      return {point[0], point[1], point[2]};
    }
  } // namespace

  void create_swept_cells(const SweptMesh  &mesh,
                          Triangulation<3> &triangulation)
  {
    std::vector<Point<3>> vertices;
    for (const auto &vertex : mesh.vertices())
      vertices.push_back(as_point(vertex));
    std::vector<CellData<3>> cells;
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      {
        cells.emplace_back();
        const auto corners = mesh.corners(cell);
        for (const unsigned int v : GeometryInfo<3>::vertex_indices())
          cells.back().vertices[v] = corners[v];
      }
    triangulation.create_triangulation(vertices, cells, SubCellData());
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          {
            const auto boundary = mesh.boundary(part_of(cell).coarse_cell, f);
            cell->face(f)->set_boundary_id(
              boundary == SectionBoundary::contact ? contact_boundary
              : boundary == SectionBoundary::hub   ? hub_boundary
                                                   : free_boundary);
          }
  }

  Point<3> swept_chart_point(const SweptMesh         &mesh,
                             const SweptCellIterator &cell,
                             const unsigned int       vertex)
  {
    const PartOfCoarseCell part = part_of(cell);
    return as_point(mesh.chart_point(part.coarse_cell, part.corner(vertex)));
  }

  std::pair<Point<3>, Point<3>> swept_chart_box(const SweptMesh         &mesh,
                                                const SweptCellIterator &cell)
  {
    const PartOfCoarseCell part = part_of(cell);
    return chart_box(mesh, part.coarse_cell, part.lower, part.size);
  }

  void move_vertices(const SweptMesh &mesh, Triangulation<3> &triangulation)
  {
    std::vector<bool> is_placed(triangulation.n_vertices());
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const PartOfCoarseCell part = part_of(cell);
        for (const unsigned int v : cell->vertex_indices())
          if (!is_placed[cell->vertex_index(v)])
            {
              is_placed[cell->vertex_index(v)] = true;
              cell->vertex(v) =
                as_point(mesh.body_point(part.coarse_cell, part.corner(v)));
            }
      }
  }
} // namespace RollingContact
