#ifndef rolling_contact_mesh_wheel_section_mesh_h
#define rolling_contact_mesh_wheel_section_mesh_h

#include <rolling_contact/mesh/placed_profile.h>
#include <rolling_contact/mesh/section_mesh.h>
#include <rolling_contact/mesh/surface_chart.h>

namespace RollingContact
{
  /**
   * Measures of a generic wheel like those of the UIC, of no drawing: a rim of
   * 68 mm below the tape circle from the back of the flange to a chamfer of 5
   * mm, a web of 24 mm at the rim and 34 mm at the hub, a hub of 40 mm. Radii
   * and places across in its profile's axes. Units: m.
   */
  struct WheelMeasures
  {
    /** For a wheel of this radius at the tape circle and of its bore. */
    WheelMeasures(const double radius, const double bore);

    double radius, bore, rim_inside, hub_outside;

    static constexpr double rim_depth = 68e-3, hub_depth = 40e-3,
                            shortest_web = 0.06;
    static constexpr double flange_back = -70e-3, chamfer = 5e-3;
    static constexpr double hub_begin = -95e-3, hub_end = 80e-3;
    static constexpr double web_at_rim = 24e-3, web_at_hub = 34e-3;
    static constexpr double middle_at_rim = -18e-3, middle_at_hub = -8e-3;
  };

  /**
   * The section of a wheel: a strip under the running surface with corners at
   * multiples of a cell's size near the contact, at most so deep, flange, rim,
   * web and hub. Points are across and outwards from the axle; the bore is its
   * hub. The third number is the radius on which x is measured, on the running
   * surface its own, elsewhere @p rolling_radius. Units: m.
   */
  SectionMesh wheel_section_mesh(const PlacedProfile  &placed,
                                 const RunningSurface &surface,
                                 const WheelMeasures  &measures,
                                 const double          rolling_radius,
                                 const CoarseCells    &across,
                                 const double          deepest);
} // namespace RollingContact

#endif
