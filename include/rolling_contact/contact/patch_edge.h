#ifndef rolling_contact_contact_patch_edge_h
#define rolling_contact_contact_patch_edge_h

#include <rolling_contact/contact/contact_operators.h>

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

  /**
   * The edge of the patch free of what nodal forces over areas deviate from the
   * pressure by next to an edge: that of SquareRootEdge, if seven nodes, of a
   * straight edge six, are as far from each other and the pressure ends like a
   * square root; elsewhere patch_edge(), which lies up to a quarter of an
   * element farther out. The edge is @p curved that is no straight line across.
   * Units: m.
   */
  double recovered_edge(const std::vector<double> &x,
                        const std::vector<double> &pressure,
                        const bool                 curved,
                        const NodalForces          forces);
} // namespace RollingContact

#endif
