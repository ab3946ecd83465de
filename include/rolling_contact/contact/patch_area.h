#ifndef rolling_contact_contact_patch_area_h
#define rolling_contact_contact_patch_area_h

#include <rolling_contact/contact/resultants.h>

namespace RollingContact
{
  /**
   * The part of the patch that belongs to each touching node, zero at open
   * ones: their sum is the area inside the outline, where the pressure
   * vanishes, and not of the boxes around the nodes that touch, which reach
   * over it by up to half an element. The square of the recovered pressure of
   * a Hertzian patch is a quadratic polynomial; near the outline it is taken
   * through the nodes within three elements by least squares, and the boxes
   * around nodes are cut where it vanishes. What an open node has inside
   * belongs to its touching neighbours. A node keeps all of its box where fewer
   * nodes hang together than a polynomial takes, or where none fits, as on
   * waves that the mesh does not resolve. Units: m^2.
   */
  std::vector<double> areas_in_contact(const ContactOperators    &operators,
                                       const std::vector<double> &pressure);

  /**
   * The part of the stick zone that belongs to each touching node, of what
   * areas_in_contact() says: at most @p areas, and all of them where everything
   * sticks. The box of a node next to one of the other kind is cut where mu p -
   * |q|, which ends like a square root as well, vanishes, found as the outline
   * of the patch is. With falling friction, where it does not end so, nodes
   * keep all that is theirs. Units: m^2.
   */
  std::vector<double> sticking_areas(const TangentialProblem      &tangential,
                                     const ContactState           &state,
                                     const std::vector<NodeState> &states,
                                     const std::vector<double>    &areas);

  /**
   * The sums of both over the patch. Their outlines take longer than all
   * resultants: for who shows them. Units: m^2.
   */
  struct PatchAreas
  {
    double contact = 0., stick = 0.;
  };

  PatchAreas patch_areas(const ContactProblem &problem,
                         const ContactState   &state);
} // namespace RollingContact

#endif
