#ifndef rolling_contact_mesh_abaqus_text_h
#define rolling_contact_mesh_abaqus_text_h

#include <string>

namespace RollingContact
{
  /**
   * An Abaqus input file reduced to what deal.II's reader is to see: *NODE,
   * *ELEMENT and *SURFACE with the elements of its sets, and an element in the
   * order of a mirror image turned. deal.II takes any other line after them for
   * data, elements for numbered from 1 on, and the digits in a surface's name
   * for its boundary id. Throws std::runtime_error as read_abaqus_file() does.
   */
  std::string checked_abaqus(const std::string &text,
                             const unsigned int dimension);
} // namespace RollingContact

#endif
