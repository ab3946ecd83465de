#ifndef rolling_contact_contact_sliding_response_h
#define rolling_contact_contact_sliding_response_h

#include <rolling_contact/contact/tangential_problem.h>

#include <vector>

namespace RollingContact
{
  /**
   * How much further the @p nodes slide when friction at them gives way: the
   * slip (R f)_i along their directions under losses f_j of the tractions
   * against these, at fixed pressure. Other touching nodes stick, or turn their
   * traction if they slip. R is the Schur complement of A = ds/dq onto the
   * directions e of the nodes (that of the slip, or against the traction),
   *
   *   R = A_ee - A_eo (A_oo + C)^-1 A_oe,
   *
   * o all other unknowns of touching nodes, with C = |s| / (mu p) on the
   * transverse unknown of slipping nodes, whose turn changes the traction by
   * dq_t = -mu p / |s| ds_t, and 0 elsewhere. One row and column for each of
   * @p nodes; empty if A_oo + C is singular. Units: 1/Pa.
   */
  DenseMatrix sliding_response(const TangentialProblem         &problem,
                               const NodalField                &traction,
                               const std::vector<unsigned int> &nodes);

  /**
   * The nodes that slip, |q - rho s| > mu p: where mu depends on the slip and
   * is known to a tolerance, |q| = mu p does not tell.
   */
  std::vector<unsigned int> slipping_nodes(const TangentialProblem &problem,
                                           const NodalField        &traction);
} // namespace RollingContact

#endif
