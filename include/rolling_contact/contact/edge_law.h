#ifndef rolling_contact_contact_edge_law_h
#define rolling_contact_contact_edge_law_h

#include <rolling_contact/contact/contact_problem.h>

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * A line of touching nodes from its leading edge on, in the order of the
   * flow, with the fields of the edge law for each tangential component. Units:
   * m, Pa.
   */
  struct ContactEdge
  {
    std::vector<unsigned int>          nodes;
    std::vector<double>                along;    ///< coordinates
    std::array<std::vector<double>, 2> pressure; ///< tangentially equivalent
    std::array<std::vector<double>, 2> coupling; ///< q_n
    bool slender = false; ///< elements more than twice as long as wide
    /// of the smooth parts that EdgePressure took from both fields
    std::array<std::optional<unsigned int>, 2> degree, degree_of_coupling;
  };

  /**
   * A node with two upstream and one downstream neighbour on its run, where the
   * derivative of the cubic through these four can be taken.
   */
  struct InnerNode
  {
    unsigned int node, upstream;
  };

  /**
   * The rows of the slip operators at one pressure, s = s_0 + B1 w + rate B2 w
   * + edge_rows q + edge_constants: those of the SlipOperator but where the
   * edge law takes others.
   */
  struct SlipRows
  {
    SparseRows B1; ///< 1/m
    SparseRows B2; ///< where the law holds: at the nodes, or between two

    std::vector<SparseRows>   edge_rows; ///< for each component or none, 1/Pa
    NodalField                edge_constants; ///< empty without edge_rows
    std::vector<ContactEdge>  edges;
    std::vector<unsigned int> released; ///< touching nodes without friction
    std::vector<InnerNode>    inner;    ///< where a cubic has its nodes
    std::size_t n_unresolved = 0;       ///< leading edges left to upwind 2
  };

  /**
   * The rows of the slip operator of @p problem, with the edge law if
   * @p edge_law and if the operator has one. A stick zone that begins at the
   * leading edge does not know where between two nodes the edge lies, which
   * makes every upstream B1 first order in force. The pressure knows it: next
   * to the edge, traction and pressure grow with the same square root, so g = q
   * / p is smooth there. On each line of touching nodes 1, 2, 3, ... along the
   * flow, h = x2 - x1:
   *
   *   node 1:  s = s_0 + u'(x1) from nodes 1, 2, 3
   *                + kappa [q1 - p1 (a g2 - b g3 + c)],
   *            kappa = 2 |A_11 - A_21| / h, A = W_tt H, for a traction spread
   *            across the flow over the length h;
   *   next nodes whose second upstream point lies outside the contact:
   *            s = s_0 + (u(x) - u(x-d)) / d, all at x - d/2;
   *   nodes that slide behind a node that slides, inside a run:
   *            s = s_0 + u'(x) of the cubic through k-2, k-1, k, k+1;
   *   others:  second order upstream.
   *
   * a, b and c are those of @p scheme, or 1, 0, 0; it also tells which nodes
   * slide. There traction follows the direction of the slip, and the error of
   * upwind 2, -h^2/3 u''', would be the largest one under spin; the cubic is of
   * third order, and like upwind 2 it sees a sawtooth. p is the
   * tangentially equivalent pressure. A first node where that pulls barely
   * touches, and the next one counts as first: it is released from friction
   * where g is extrapolated, and follows the next node (g1 = g2) elsewhere.
   * With normal-tangential coupling g = (q - q_n) / p, where q_n answers the
   * tangential displacement of the pressure near the edge. For both see
   * EdgePressure. kappa is a weight: it makes the term in brackets a slip of
   * the size of the others.
   *
   * A line of a refined part that begins where the point one element upstream
   * is in contact has no leading edge: its first nodes keep their rows, which
   * interpolate upstream. A point between nodes is in contact if all nodes it
   * is interpolated from touch.
   *
   * What is smooth in the displacements is found anew at each pressure; on
   * edges that begin at a node where one of @p like does, it is of the degrees
   * of that one, so that small changes of the pressure change the rows by as
   * little.
   */
  SlipRows slip_rows(const ContactProblem           &problem,
                     const std::vector<double>      &pressure,
                     const SlipScheme               &scheme,
                     const bool                      edge_law,
                     const std::vector<ContactEdge> &like = {});
} // namespace RollingContact

#endif
