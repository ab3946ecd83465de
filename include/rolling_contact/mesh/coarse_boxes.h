#ifndef rolling_contact_mesh_coarse_boxes_h
#define rolling_contact_mesh_coarse_boxes_h

#include <rolling_contact/mesh/chart.h>
#include <rolling_contact/mesh/grading.h>
#include <rolling_contact/mesh/swept_mesh.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * The coarse cells of a body as boxes of its chart between break points:
   * equal ones of this size under the contact, where halving them gives all
   * bodies the same surface nodes, and longer ones away from it, along x,
   * across and in depth. Units: m.
   */
  template <int dim>
  struct CoarseBoxes
  {
    double                               size = 0.;
    std::unique_ptr<BodyChart<dim>>      chart;
    std::array<std::vector<double>, dim> breaks;
  };

  /**
   * The coarse cells whose size, a power of two times the element's, makes the
   * mesh of a generated body with the fewest cells, and how many those are at
   * least, counted without making the mesh; a number above @p enough if there
   * are more. With a uniform grading boxes all alike, none longer than it asks.
   */
  template <int dim>
  std::pair<CoarseBoxes<dim>, double>
  fewest_cells(const std::shared_ptr<const BodyShape> &shape,
               const Grading<dim>                     &grading,
               const double                            enough);

  /**
   * The grading of the cells of a body with a swept section, of which @p
   * grading asks for the nodes of the interface.
   */
  Grading<3> grading_of_body(const BodyShape &shape, const Grading<3> &grading);

  /**
   * As fewest_cells() for a body with a swept section; as few as its own
   * coarse cells or a uniform grading make. Throws InputError if none of the
   * sizes makes cells that are fit for use.
   */
  std::pair<std::shared_ptr<const SweptMesh>, double>
  fewest_swept_cells(const std::shared_ptr<const BodyShape> &shape,
                     const Grading<3>                       &grading,
                     const double                            enough);
} // namespace RollingContact

#endif
