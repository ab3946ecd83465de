#ifndef rolling_contact_tests_references_section_properties_h
#define rolling_contact_tests_references_section_properties_h

#include <rolling_contact/surfaces/outline.h>

namespace RollingContact::Profiles
{
  /**
   * What a beam of this section needs: area (m^2), height of its centroid (m),
   * and second moments of area about the axes across and up through it (m^4).
   */
  struct SectionProperties
  {
    double area, height, I_y, I_z;
  };

  /**
   * Properties of the section inside the polygon of these points (across, up),
   * in either sense.
   */
  SectionProperties
  section_properties(const std::vector<Outline::Point> &polygon);
} // namespace RollingContact::Profiles

#endif
