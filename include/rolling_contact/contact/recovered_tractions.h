#ifndef rolling_contact_contact_recovered_tractions_h
#define rolling_contact_contact_recovered_tractions_h

#include <rolling_contact/contact/resultants.h>

namespace RollingContact
{
  /**
   * Pressure and traction at the places of the nodes. Those of a ContactState
   * are forces over areas: their sums are exact, but next to the edges of the
   * patch and of the stick zone, where they end like square roots, they are
   * means that differ from the value at the node by up to a tenth of the peak.
   * Units: Pa.
   */
  struct RecoveredTractions
  {
    std::vector<double> pressure;
    NodalField          traction;
  };

  /**
   * Recover them from a state. See SquareRootEdge for the equation; in 3D edges
   * that lie at an angle take the mean of what the lines along and across the
   * flow say, weighted by the squares of their slopes. Nodes keep the values of
   * the state where none of the edges near them ends like a square root on at
   * least six nodes of equal distance. |q| <= mu p holds, with equality at the
   * nodes that slide.
   */
  RecoveredTractions recovered_tractions(const TangentialProblem &tangential,
                                         const ContactState      &state);

  /**
   * The pressure alone, which friction does not change.
   */
  std::vector<double> recovered_pressure(const ContactOperators    &operators,
                                         const std::vector<double> &pressure);

  /**
   * What the friction bound leaves, mu p - |q|: on every line the stick zone
   * ends like a square root downstream. Units: Pa.
   */
  std::vector<double> recovered_margin(const TangentialProblem      &tangential,
                                       const std::vector<NodeState> &states,
                                       const ContactState           &state);

  /**
   * Recover them with the friction and the slip rows of tangential_problem().
   */
  RecoveredTractions recovered_tractions(const ContactProblem &contact,
                                         const ContactState   &state);
} // namespace RollingContact

#endif
