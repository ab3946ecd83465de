#ifndef rolling_contact_mesh_gmsh_text_h
#define rolling_contact_mesh_gmsh_text_h

#include <string>

namespace RollingContact
{
  /**
   * Throws std::runtime_error if the text is no mesh of Gmsh that deal.II can
   * read: formats 2.0 to 2.2, 4.0 and 4.1 in ASCII, elements of first order,
   * all numbers there. deal.II believes what a file announces.
   */
  void
  check_gmsh(const std::string &text);
} // namespace RollingContact

#endif
