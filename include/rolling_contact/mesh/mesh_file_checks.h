#ifndef rolling_contact_mesh_mesh_file_checks_h
#define rolling_contact_mesh_mesh_file_checks_h

#include <deal.II/grid/tria.h>

#include <rolling_contact/mesh/mesh_file.h>

#include <vector>

namespace RollingContact
{
  /**
   * Throws InputError unless the cells as read are quadrilaterals or hexahedra
   * of positive measure everywhere, in one part.
   */
  template <int dim>
  void check_cells(const MeshFile                   &file,
                   const dealii::Triangulation<dim> &cells);

  /**
   * Throws InputError unless both boundary ids are on the boundary.
   */
  template <int dim>
  void check_boundary_ids(const MeshFile                   &file,
                          const dealii::Triangulation<dim> &cells);

  /**
   * A face with the contact boundary's id, and z of its outward unit normal in
   * the body's frame.
   */
  struct ContactFace
  {
    FileMesh::Face corners;
    double         upwards;
  };

  /**
   * Least z of the outward unit normal of a face that looks towards the other
   * body. Units: 1.
   */
  inline constexpr double least_upwards = 0.3;

  /**
   * Throws InputError unless the contact boundary passes through the origin,
   * with the body below it, away from the hub.
   */
  void check_contact_boundary(const MeshFile                 &file,
                              const FileMesh                 &mesh,
                              const std::vector<ContactFace> &contact_faces);
} // namespace RollingContact

#endif
