#ifndef rolling_contact_contact_patch_edge_h
#define rolling_contact_contact_patch_edge_h

#include <vector>

namespace RollingContact
{
  /**
   * Position at which the pressure of a line of touching nodes vanishes beyond
   * the first of them: p^2 of a Hertzian patch is a parabola, taken through the
   * third to fifth node; with fewer than ten nodes a straight line through the
   * first two. The nodes may run in either direction. Units: m.
   */
  double patch_edge(const std::vector<double> &x,
                    const std::vector<double> &pressure);
} // namespace RollingContact

#endif
