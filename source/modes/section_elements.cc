#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_tools.h>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/modes/section_elements.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /// how often cells at a singularity are divided
    const unsigned int corner_levels = 3;

    /// corners of the unit square, the first coordinate fastest
    Point<2> unit_corner(const unsigned int v)
    {
      return {double(v & 1), double(v >> 1)};
    }

    /**
     * The quadrilaterals as cells of positive area whose edges have one
     * direction each, numbered as they are in the section.
     */
    std::vector<CellData<2>> cells_of(const SectionMesh &section)
    {
      std::vector<CellData<2>> cells;
      for (unsigned int quad = 0; quad < section.quads().size(); ++quad)
        {
          CellData<2> cell;
          cell.vertices.assign(section.quads()[quad].corners.begin(),
                               section.quads()[quad].corners.end());
          const auto  &at = section.vertices();
          const auto  &v  = cell.vertices;
          const double area =
            (at[v[3]][0] - at[v[0]][0]) * (at[v[2]][1] - at[v[1]][1]) -
            (at[v[2]][0] - at[v[1]][0]) * (at[v[3]][1] - at[v[0]][1]);
          if (area < 0.)
            {
              std::swap(cell.vertices[0], cell.vertices[1]);
              std::swap(cell.vertices[2], cell.vertices[3]);
            }
          cells.push_back(cell);
        }
      GridTools::consistently_order_cells(cells);
      return cells;
    }

    const types::boundary_id hub_of_section = 1;

    /// of the sum of angles at a corner, beyond which stresses are singular
    const double re_entrant = 1.1 * pi;

    double
    angle_at(const Point<2> &corner, const Point<2> &a, const Point<2> &b)
    {
      const Tensor<1, 2> to_a = a - corner, to_b = b - corner;
      return std::acos(
        std::clamp(to_a * to_b / (to_a.norm() * to_b.norm()), -1., 1.));
    }

    /**
     * Corners of the section where stresses have a singularity: those that
     * are re-entrant, and the ends of what is held.
     */
    std::set<unsigned int> singular_corners(const Triangulation<2> &cells,
                                            const bool              clamped)
    {
      std::map<unsigned int, double>       angles;
      std::map<unsigned int, unsigned int> n_free, n_held;
      for (const auto &cell : cells.active_cell_iterators())
        {
          for (const unsigned int v : cell->vertex_indices())
            // its neighbours on the cell: one differs in each direction
            angles[cell->vertex_index(v)] += angle_at(cell->vertex(v),
                                                      cell->vertex(v ^ 1),
                                                      cell->vertex(v ^ 2));
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              for (const unsigned int v : {0, 1})
                ++(clamped && face->boundary_id() == hub_of_section
                     ? n_held
                     : n_free)[face->vertex_index(v)];
        }
      std::set<unsigned int> corners;
      for (const auto &[vertex, angle] : angles)
        if (n_free[vertex] > 0 && (angle > re_entrant || n_held[vertex] > 0))
          corners.insert(vertex);
      return corners;
    }

    /** A place in a cell as one of the unit square of its coarse cell. */
    Point<2> in_coarse_cell(Triangulation<2>::cell_iterator cell,
                            Point<2>                        local)
    {
      while (cell->level() > 0)
        {
          const auto parent = cell->parent();
          for (unsigned int child = 0; child < parent->n_children(); ++child)
            if (parent->child(child) == cell)
              {
                local =
                  GeometryInfo<2>::child_to_cell_coordinates(local, child);
                break;
              }
          cell = parent;
        }
      return local;
    }
  } // namespace

  SectionElements::SectionElements(const SectionMesh &section,
                                   const Material    &material,
                                   const bool         clamped,
                                   const unsigned int degree)
    : material(material)
    , element(degree)
    , mapping(degree)
    , dofs(triangulation)
  {
    std::vector<Point<2>> vertices;
    for (const SectionPoint &point : section.vertices())
      vertices.emplace_back(point[0], point[1]);
    triangulation.create_triangulation(vertices,
                                       cells_of(section),
                                       SubCellData());
    find_hub(section);
    refine(clamped);
    map(section);
    dofs.distribute_dofs(element);
    DoFTools::make_hanging_node_constraints(dofs, constraints);
    if (clamped)
      DoFTools::make_zero_boundary_constraints(dofs,
                                               hub_of_section,
                                               constraints);
    constraints.close();
  }

  bool
  SectionElements::is_of_hub(const DoFHandler<2>::active_face_iterator &edge)
  {
    return edge->at_boundary() && edge->boundary_id() == hub_of_section;
  }

  void SectionElements::find_hub(const SectionMesh &section)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      for (unsigned int edge = 0; edge < 4; ++edge)
        if (section.quads()[cell->index()].boundary[edge] ==
            SectionBoundary::hub)
          {
            const auto ends = section.ends_of_edge(cell->index(), edge);
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() &&
                  std::minmax(face->vertex_index(0), face->vertex_index(1)) ==
                    std::minmax(ends[0], ends[1]))
                face->set_boundary_id(hub_of_section);
          }
  }

  void SectionElements::refine(const bool clamped)
  {
    const auto corners = singular_corners(triangulation, clamped);
    for (unsigned int level = 0; level < corner_levels; ++level)
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          for (const unsigned int v : cell->vertex_indices())
            if (corners.count(cell->vertex_index(v)) > 0)
              cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
      }
  }

  void SectionElements::map(const SectionMesh &section)
  {
    mapping.initialize(
      triangulation, [&](const Triangulation<2>::cell_iterator &cell) {
        Triangulation<2>::cell_iterator coarse = cell;
        while (coarse->level() > 0)
          coarse = coarse->parent();
        const unsigned int    quad    = coarse->index();
        const auto           &corners = section.quads()[quad].corners;
        std::vector<Point<2>> points;
        for (const Point<2> &local : element.get_unit_support_points())
          {
            // corners of the cell may be others first in the section
            const Point<2> in_coarse = in_coarse_cell(cell, local);
            Point<2>       own;
            for (unsigned int v = 0; v < 4; ++v)
              own += GeometryInfo<2>::d_linear_shape_function(in_coarse, v) *
                     unit_corner(std::find(corners.begin(),
                                           corners.end(),
                                           coarse->vertex_index(v)) -
                                 corners.begin());
            const SectionPoint point = section.at(quad, own[0], own[1]);
            points.emplace_back(point[0], point[1]);
          }
        return points;
      });
  }

  std::vector<std::pair<types::global_dof_index, double>>
  SectionElements::parts_of(const types::global_dof_index node) const
  {
    if (!constraints.is_constrained(node))
      return {{node, 1.}};
    return *constraints.get_constraint_entries(node);
  }
} // namespace RollingContact
