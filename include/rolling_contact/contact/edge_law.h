#ifndef rolling_contact_contact_edge_law_h
#define rolling_contact_contact_edge_law_h

#include <rolling_contact/contact/contact_problem.h>

namespace RollingContact
{
  /**
   * The edge law. A stick zone that begins at the leading edge does not know
   * where between two nodes the edge lies, which makes every upstream B1 first
   * order in force. The pressure knows it: next to the edge, traction and
   * pressure grow with the same square root, so q / p is smooth there. On each
   * line of touching nodes 1, 2, 3, ... along the flow, h = x2 - x1, h2 = x3 -
   * x2, r = h / h2:
   *
   *   node 1:  s = s_0 + u'(x1) from nodes 1, 2, 3 + kappa L(q),
   *            L = q1 - p1 q2/p2                              (constant law) or
   *            L = q1 - p1 [(1 + r) q2/p2 - r q3/p3]          (linear law),
   *            kappa = 2 |A_11 - A_21| / h, A = W_tt H;
   *   next nodes whose second upstream point lies outside the contact:
   *            s = s_0 + (u(x) - u(x-d)) / d, all at x - d/2;
   *   others:  second order upstream.
   *
   * The linear law holds where the first three of at least four nodes stick,
   * see sticking_edges(); s of the whole line is the known one in full slip. p
   * is the discrete companion of the pressure in the tangential compliance. A
   * first node whose companion pulls barely touches, and the next one counts as
   * first: it carries no friction where the linear law holds, and follows the
   * next node by the constant law elsewhere. With normal-tangential coupling L
   * acts on q - q_n, where q_n answers the tangential displacement of the
   * pressure near the edge. For both see EdgeCompanion.
   *
   * A line of a refined part that begins where the point one element upstream
   * is in contact has no leading edge: its first nodes keep their rows, which
   * interpolate upstream. A point between nodes is in contact if all nodes it
   * is interpolated from touch.
   */
  void
  apply_edge_law(const std::vector<double> &pressure,
                 const std::vector<bool>   &linear_edges,
                 TangentialProblem         &problem);

  /**
   * True at the first node of each edge of at least four touching nodes whose
   * first three nodes, from the one numbered @p first on, stick at this
   * traction; empty if there is none. The linear law holds where all three
   * stick under it.
   */
  std::vector<bool>
  sticking_edges(const TangentialProblem   &problem,
                 const std::vector<double> &traction,
                 const unsigned int         first = 0);
} // namespace RollingContact

#endif
