#ifndef rolling_contact_analyses_interface_grid_h
#define rolling_contact_analyses_interface_grid_h

#include <rolling_contact/contact/trace.h>
#include <rolling_contact/mesh/grading.h>

namespace RollingContact
{
  /**
   * The interface of bodies that are all read from files: equal boxes in the
   * zone of contact nodes, the surface elements that generated bodies would
   * have there.
   */
  template <int dim>
  Trace
  interface_grid(const Grading<dim> &grading);
} // namespace RollingContact

#endif
