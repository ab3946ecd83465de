#ifndef rolling_contact_mesh_ring_places_h
#define rolling_contact_mesh_ring_places_h

#include <rolling_contact/mesh/absorber_ring.h>
#include <rolling_contact/mesh/body_shape.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * How far a circle of nodes that a ring of absorbers hangs on may be from the
   * place asked for, over the radius of the body.
   */
  inline constexpr double farthest_ring = 0.1;

  /**
   * Throws InputError, naming @p section, if a ring is farther than that from
   * the section of a body of revolution, so that no mesh of it has a circle of
   * nodes for it. Bodies without an axle or from a mesh of hexahedra are not
   * judged.
   */
  void check_ring_places(const std::vector<AbsorberRing> &rings,
                         const std::string               &section,
                         const BodyShape                 &shape);
} // namespace RollingContact

#endif
