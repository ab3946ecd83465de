#ifndef rolling_contact_mesh_gmsh_text_h
#define rolling_contact_mesh_gmsh_text_h

#include <string>

namespace RollingContact
{
  /**
   * The text of a mesh of Gmsh as deal.II's reader is to see it: groups with a
   * minus, which take their entities the other way round, without it. Throws
   * std::runtime_error, with the line, if deal.II cannot read it: formats 2.0
   * to 2.2, 4.0 and 4.1 in ASCII, sections in their order, elements of first
   * order, all numbers there and in their range. deal.II believes what a file
   * announces. In two dimensions its quadrilaterals share edges two by two.
   */
  std::string checked_gmsh(const std::string &text,
                           const unsigned int dimension);
} // namespace RollingContact

#endif
