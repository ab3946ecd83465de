#ifndef rolling_contact_contact_patch_edges_h
#define rolling_contact_contact_patch_edges_h

#include <rolling_contact/contact/contact_operators.h>

#include <vector>

namespace RollingContact
{
  /**
   * Where the pressure of a patch vanishes: along x on the line of nodes
   * nearest to y = 0, and across as far as it reaches. Units: m.
   */
  struct PatchEdges
  {
    double begin_x = 0., end_x = 0., begin_y = 0., end_y = 0.;
  };

  /**
   * The edges as patch_edge() extrapolates nodal pressures, across on the lines
   * of nodes along y that reach farthest. They lie up to a quarter of an
   * element outside of the patch.
   */
  PatchEdges extrapolated_edges(const ContactOperators    &operators,
                                const std::vector<double> &pressure);

  /**
   * The edges of the recovered pressure, by recovered_edge() on the same lines;
   * across where they lie farthest by the parabola through those of this line
   * and the two beside it.
   */
  PatchEdges recovered_edges(const ContactOperators    &operators,
                             const std::vector<double> &pressure);
} // namespace RollingContact

#endif
