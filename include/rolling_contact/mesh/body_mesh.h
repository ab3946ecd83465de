#ifndef rolling_contact_mesh_body_mesh_h
#define rolling_contact_mesh_body_mesh_h

#include <deal.II/grid/tria.h>

#include <rolling_contact/mesh/chart.h>
#include <rolling_contact/mesh/grading.h>
#include <rolling_contact/mesh/swept_mesh.h>

#include <limits>
#include <memory>

namespace RollingContact
{
  /**
   * Boundary ids of every body mesh.
   */
  enum BoundaryId : dealii::types::boundary_id
  {
    free_boundary    = 0,
    contact_boundary = 1,
    hub_boundary     = 2
  };

  enum class MeshKind
  {
    serial,     ///< whole, on this rank alone
    distributed ///< by p4est over all ranks
  };

  /**
   * A body mesh and the chart it lives in, one of boxes or, in a swept section,
   * of coarse cells; a mesh that the shape brings has no chart.
   */
  template <int dim>
  struct BodyMesh
  {
    MeshKind                                    kind = MeshKind::serial;
    std::unique_ptr<BodyChart<dim>>             chart;
    std::shared_ptr<const SweptMesh>            swept; ///< 3D only
    std::unique_ptr<dealii::Triangulation<dim>> triangulation;

    using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

    /**
     * A corner of a cell in the chart, x counted from the contact point.
     */
    dealii::Point<dim> chart_point(const CellIterator &cell,
                                   const unsigned int  vertex) const;

    /**
     * Corners of a cell in the chart, x counted from the contact point.
     */
    std::pair<dealii::Point<dim>, dealii::Point<dim>>
    chart_box(const CellIterator &cell) const;
  };

  /**
   * Cells that the mesh of a generated body will have at least, counted without
   * making it; where sizes change it has some more. A number above @p enough if
   * there are more than that.
   */
  template <int dim>
  double
  least_cells(const std::shared_ptr<const BodyShape> &shape,
              const Grading<dim>                     &grading,
              const double enough = std::numeric_limits<double>::infinity());

  /**
   * Mesh a body, or take the mesh it brings: boxes in its chart, refined as @p
   * grading asks. The coarse mesh has an edge at x = offset * element_size_x
   * and, under the contact, cells that are powers of two of the element size,
   * which makes the surface nodes of two bodies match; in 3D those further away
   * are longer. At the bottom of a cover lies an edge as well, above which
   * cells have its material id. A section from a file keeps its coarse cells,
   * whose elements under the contact face an interface with those of @p
   * grading. Both kinds of mesh have the same cells and vertices.
   */
  template <int dim>
  BodyMesh<dim> make_body_mesh(const std::shared_ptr<const BodyShape> &shape,
                               const Grading<dim>                     &grading,
                               const MeshKind kind = MeshKind::serial);
} // namespace RollingContact

#endif
