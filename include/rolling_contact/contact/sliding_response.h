#ifndef rolling_contact_contact_sliding_response_h
#define rolling_contact_contact_sliding_response_h

#include <rolling_contact/contact/contact_problem.h>

#include <vector>

namespace RollingContact
{
  /**
   * What less friction does to the slip. The nodes lose a traction f_j along
   * their slip (that against which they stick) and slide by (R f)_i more, while
   * the other touching nodes stick and slipping nodes may turn: with A = ds/dq,
   * e along and t across the slip, a turn changes the traction by dq_t = -mu p
   * / |s| ds_t, so C = |s| / (mu p) across slipping nodes and 0 elsewhere,
   *
   *   R = A_ee - A_eo (A_oo + C)^-1 A_oe,   o all but the e of the nodes.
   *
   * Pressure is fixed. Empty if A_oo + C is singular. Units: 1/Pa.
   */
  DenseMatrix
  sliding_response(const TangentialProblem         &problem,
                   const std::vector<double>       &traction,
                   const std::vector<unsigned int> &nodes);

  /**
   * The nodes that slip, |q - rho s| > mu p: where mu falls and is known to a
   * tolerance, |q| = mu p does not tell.
   */
  std::vector<unsigned int>
  slipping_nodes(const TangentialProblem   &problem,
                 const std::vector<double> &traction);
} // namespace RollingContact

#endif
