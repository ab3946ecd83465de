#ifndef rolling_contact_contact_node_lines_h
#define rolling_contact_contact_node_lines_h

#include <rolling_contact/contact/contact_operators.h>

namespace RollingContact
{
  /**
   * The nodes of each line along @p axis (0: x, 1: y), in the order of their
   * coordinates, the lines in the order of theirs.
   */
  std::vector<std::vector<unsigned int>>
  node_lines(const ContactOperators &operators, const unsigned int axis);

  /**
   * Widths of parallel lines at these ascending places, more than one: half the
   * distance of the lines on either side, at the ends of the one. Units: m.
   */
  std::vector<double> widths_of_lines(const std::vector<double> &places);
} // namespace RollingContact

#endif
