#ifndef rolling_contact_mesh_swept_cells_h
#define rolling_contact_mesh_swept_cells_h

#include <deal.II/grid/tria.h>

#include <rolling_contact/mesh/swept_mesh.h>

#include <utility>

namespace RollingContact
{
  using SweptCellIterator = dealii::Triangulation<3>::cell_iterator;

  /**
   * Create the coarse cells of a swept section, with boundary ids.
   */
  void create_swept_cells(const SweptMesh          &mesh,
                          dealii::Triangulation<3> &triangulation);

  /**
   * The chart point of a corner of a cell of any level, x from the contact.
   */
  dealii::Point<3> swept_chart_point(const SweptMesh         &mesh,
                                     const SweptCellIterator &cell,
                                     const unsigned int       vertex);

  /**
   * Lower and upper corner of a cell in the chart.
   */
  std::pair<dealii::Point<3>, dealii::Point<3>>
  swept_chart_box(const SweptMesh &mesh, const SweptCellIterator &cell);

  /**
   * Put all vertices where the coarse cells' maps have them: those of the
   * running surface on the profile. Cells must not be refined after that.
   */
  void move_vertices(const SweptMesh          &mesh,
                     dealii::Triangulation<3> &triangulation);
} // namespace RollingContact

#endif
