#ifndef rolling_contact_surfaces_rail_section_h
#define rolling_contact_surfaces_rail_section_h

#include <rolling_contact/surfaces/outline.h>

namespace RollingContact::Profiles
{
  /**
   * Height of the rail 60E1 from its sole to the crown. Units: m.
   */
  constexpr double rail_60e1_height = 0.172;

  /**
   * The field side of the section of the rail 60E1 (EN 13674-1), (across, up
   * from the middle of the sole), from the crown to the middle of the sole:
   * tangent arcs and lines. The head is rail_head("60E1"); the heights at
   * which the web begins to widen, 92.37 and 60.40 mm, are fitted to published
   * points of the outline, within 0.07 mm of them. Units: m.
   */
  Outline half_section_60e1();

  /**
   * Points on that outline. Units: m.
   */
  struct RailLandmarks
  {
    Outline::Point side_end;     ///< of the head, where its lower corner begins
    Outline::Point lower_corner; ///< of the head, in the middle of its arc
  };

  RailLandmarks landmarks_60e1();
} // namespace RollingContact::Profiles

#endif
