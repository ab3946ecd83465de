#ifndef rolling_contact_pair_interface_mesh_h
#define rolling_contact_pair_interface_mesh_h

#include <rolling_contact/contact/trace.h>
#include <rolling_contact/mesh/grading.h>

namespace RollingContact
{
  /**
   * The interface of bodies that are all read from mesh files: equal boxes in
   * the zone of contact nodes, which are the surface elements that generated
   * bodies would have there.
   */
  template <int dim>
  Trace interface_mesh(const Grading<dim> &grading);
} // namespace RollingContact

#endif
