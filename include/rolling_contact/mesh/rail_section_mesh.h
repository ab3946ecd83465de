#ifndef rolling_contact_mesh_rail_section_mesh_h
#define rolling_contact_mesh_rail_section_mesh_h

#include <rolling_contact/mesh/placed_profile.h>
#include <rolling_contact/mesh/section_mesh.h>
#include <rolling_contact/mesh/surface_chart.h>

namespace RollingContact
{
  /**
   * The section of a rail: a strip under the running surface with corners at
   * multiples of a cell's size near the contact, the core of the head, and
   * neck, web and foot of a 60E1. Cells of the strip are at most so deep.
   * Points are across and up from the sole; the sole is its hub. Units: m.
   */
  SectionMesh rail_section_mesh(const RunningSurface &surface,
                                const CoarseCells    &across,
                                const double          deepest);
} // namespace RollingContact

#endif
