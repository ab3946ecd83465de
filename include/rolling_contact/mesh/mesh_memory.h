#ifndef rolling_contact_mesh_mesh_memory_h
#define rolling_contact_mesh_mesh_memory_h

#include <rolling_contact/mesh/body_mesh.h>

#include <string>

namespace RollingContact
{
  /**
   * Cells that fit into 70 % of the free memory; infinity if that is not known.
   */
  template <int dim>
  double largest_mesh(const MeshKind kind);

  /**
   * Throws MemoryError with the @p remedy if a mesh of @p n_cells, or those of
   * several bodies together as @p what says, would need more than 70 % of the
   * free memory, by the bytes of a cell seen in runs: mesh and stiffness, with
   * factor and condensation or with the multigrid levels. The ranks are taken
   * to share one machine.
   */
  template <int dim>
  void check_mesh_memory(const double       n_cells,
                         const MeshKind     kind,
                         const std::string &remedy,
                         const std::string &what = "The mesh of a body");
} // namespace RollingContact

#endif
