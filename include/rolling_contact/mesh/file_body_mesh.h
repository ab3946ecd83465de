#ifndef rolling_contact_mesh_file_body_mesh_h
#define rolling_contact_mesh_file_body_mesh_h

#include <rolling_contact/mesh/body_mesh.h>

namespace RollingContact
{
  /**
   * The mesh of a body that was read from a file, serial and without a chart.
   * Vertices have the numbers of the FileMesh. Throws MemoryError if it does
   * not fit.
   */
  template <int dim>
  BodyMesh<dim> file_body_mesh(const FileMesh &mesh);

  /**
   * The active cells of a mesh in space as a FileMesh: its vertices with their
   * numbers, the faces of the hub, and those of the contact boundary that look
   * towards the other body, which is where this unit vector points.
   */
  FileMesh as_file_mesh(
    const BodyMesh<3>         &mesh,
    const dealii::Tensor<1, 3> towards_other = dealii::Point<3>(0., 0., 1.));
} // namespace RollingContact

#endif
