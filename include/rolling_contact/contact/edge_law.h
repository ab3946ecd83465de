#ifndef rolling_contact_contact_edge_law_h
#define rolling_contact_contact_edge_law_h

#include <rolling_contact/contact/contact_problem.h>

namespace RollingContact
{
  /**
   * The edge law. A stick zone that begins at the leading edge does not know
   * where between two nodes the edge lies, which makes every upstream B1 first
   * order in force. The pressure knows it: next to the edge, traction and
   * pressure grow with the same square root, so g = q / p is smooth there. On
   * each line of touching nodes 1, 2, 3, ... along the flow, h = x2 - x1:
   *
   *   node 1:  s = s_0 + u'(x1) from nodes 1, 2, 3
   *                + kappa [q1 - p1 (a g2 - b g3 + c)],
   *            kappa = 2 |A_11 - A_21| / h, A = W_tt H;
   *   next nodes whose second upstream point lies outside the contact:
   *            s = s_0 + (u(x) - u(x-d)) / d, all at x - d/2;
   *   others:  second order upstream.
   *
   * a, b and c are those of extrapolate_edges(). p is the discrete companion of
   * the pressure in the tangential compliance. A first node whose companion
   * pulls barely touches, and the next one counts as first: it carries no
   * friction where g is extrapolated, and follows the next node (g1 = g2)
   * elsewhere. With normal-tangential coupling g = (q - q_n) / p, where q_n
   * answers the tangential displacement of the pressure near the edge. For both
   * see EdgeCompanion.
   *
   * A line of a refined part that begins where the point one element upstream
   * is in contact has no leading edge: its first nodes keep their rows, which
   * interpolate upstream. A point between nodes is in contact if all nodes it
   * is interpolated from touch.
   */
  void
  apply_edge_law(const std::vector<double>            &pressure,
                 const std::vector<EdgeExtrapolation> &extrapolations,
                 TangentialProblem                    &problem);

  /**
   * The extrapolations the traction asks for. With e the value of g at the
   * first node that slips, rho = g - e vanishes with the square root of the
   * distance to the transition, as in Carter's solution: there rho^2 =
   * (l - x)/(2a - x) times a constant, l the length of the stick zone and x
   * from the edge. So rho^2 is taken as linear in x,
   *
   *   |rho1|^2 = (1 + r) |rho2|^2 - r |rho3|^2,    r = (x2 - x1)/(x3 - x2),
   *
   * and what is given is its tangent, a = (1 + r) |rho2|/|rho1|, b = r
   * |rho3|/|rho1|, c = e (1 - a + b). On lines that stick throughout g itself
   * is linear; where node 1 or 2 slips and on lines of less than four nodes g1
   * = g2, and there is no entry.
   */
  std::vector<EdgeExtrapolation>
  extrapolate_edges(const TangentialProblem   &problem,
                    const std::vector<double> &traction);

  /**
   * The extrapolation at the edge that begins with a node; nullptr if there is
   * none.
   */
  const EdgeExtrapolation *
  find_edge(const std::vector<EdgeExtrapolation> &extrapolations,
            const unsigned int                    first);

  /**
   * The largest difference between two sets of extrapolations, in their
   * coefficients a and b; infinite if they are of different edges.
   */
  double
  difference(const std::vector<EdgeExtrapolation> &first,
             const std::vector<EdgeExtrapolation> &second);
} // namespace RollingContact

#endif
