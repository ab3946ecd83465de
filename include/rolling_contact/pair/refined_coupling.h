#ifndef rolling_contact_pair_refined_coupling_h
#define rolling_contact_pair_refined_coupling_h

#include <rolling_contact/mesh/hanging_vertices.h>
#include <rolling_contact/pair/mesh_file_coupling.h>
#include <rolling_contact/scene/pair_spec.h>

namespace RollingContact
{
  /**
   * As couple_to_interface(), for a mesh whose cells were halved here and
   * there: vertices that hang are none of the contact nodes, the corners that
   * they move with are.
   */
  FileSurface couple_refined_to_interface(const PairSpec        &scene,
                                          const Side             side,
                                          const FileMesh        &mesh,
                                          const HangingVertices &hanging,
                                          const Trace           &interface);
} // namespace RollingContact

#endif
