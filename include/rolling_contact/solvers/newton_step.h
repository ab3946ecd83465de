#ifndef rolling_contact_solvers_newton_step_h
#define rolling_contact_solvers_newton_step_h

#include <rolling_contact/solvers/touching_friction.h>

namespace RollingContact
{
  /**
   * The Newton step of the tractions; false if the matrix is singular. With r
   * the right hand side, A the compliance and D = mu p/|z| t t^T the derivative
   * of the projection, t along the bound: rho A dq = r of nodes that stick, and
   * dq + D (rho A dq - dq) = r, so dq = r + alpha t, of those that slide. By LU
   * factors, or, on a grid, iterations that begin with those of the lines along
   * the flow, to @p tolerance of the right hand side.
   */
  bool newton_step(const TouchingFriction    &friction,
                   const std::vector<double> &traction,
                   const double               rho,
                   const double               tolerance,
                   std::vector<double>       &step);
} // namespace RollingContact

#endif
