#ifndef rolling_contact_mesh_cell_count_h
#define rolling_contact_mesh_cell_count_h

#include <rolling_contact/mesh/chart.h>
#include <rolling_contact/mesh/grading.h>
#include <rolling_contact/mesh/swept_mesh.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * Cells that a mesh of the boxes between these break points of the chart
   * would have at least, counted without making it: those that the grading
   * alone asks for, without the ones that smooth it. Stops counting beyond
   * @p enough.
   */
  template <int dim>
  double count_cells(const std::array<std::vector<double>, dim> &breaks,
                     const BodyChart<dim>                       &chart,
                     const Grading<dim>                         &grading,
                     const double                                enough);

  /**
   * Number of cells that the coarse cells of a swept section become, each
   * divided by the places of its corners in the chart.
   */
  double count_cells(const SweptMesh  &mesh,
                     const Grading<3> &grading,
                     const double      enough);

  /**
   * Lower and upper corner in the chart of the part of a coarse cell from
   * @p lower to @p lower + @p size of its unit cube.
   */
  std::pair<dealii::Point<3>, dealii::Point<3>>
  chart_box(const SweptMesh             &mesh,
            const unsigned int           cell,
            const std::array<double, 3> &lower,
            const double                 size);
} // namespace RollingContact

#endif
