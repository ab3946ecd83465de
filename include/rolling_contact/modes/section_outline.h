#ifndef rolling_contact_modes_section_outline_h
#define rolling_contact_modes_section_outline_h

#include <rolling_contact/mesh/section_mesh.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * A point that stands for a part of the outline of a section.
   */
  struct OutlinePoint
  {
    SectionPoint          point;  ///< m
    std::array<double, 2> normal; ///< across and outwards, of either sign
    double                length; ///< of the part, m
  };

  /**
   * The outline of a section, but for its hub boundary, by two points of Gauss
   * on each of @p parts equal parts of an edge.
   */
  std::vector<OutlinePoint> outline_of(const SectionMesh &section,
                                       const unsigned int parts = 2);
} // namespace RollingContact

#endif
