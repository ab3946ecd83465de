#ifndef rolling_contact_mesh_cell_count_h
#define rolling_contact_mesh_cell_count_h

#include <rolling_contact/mesh/chart.h>
#include <rolling_contact/mesh/grading.h>

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
  double
  count_cells(const std::array<std::vector<double>, dim> &breaks,
              const BodyChart<dim>                       &chart,
              const Grading<dim>                         &grading,
              const double                                enough);
} // namespace RollingContact

#endif
