#ifndef rolling_contact_solvers_pressure_on_grid_h
#define rolling_contact_solvers_pressure_on_grid_h

#include <rolling_contact/contact/contact_problem.h>

#include <vector>

namespace RollingContact
{
  /**
   * Pressure and approach with zero gap on the active nodes, on a grid: the
   * conjugate gradients of
   *   min 1/2 f^T W f + f^T gap,   f^T share = load if that is given,
   * among nodal forces f of the active nodes, which begin at those of the
   * state, with Fourier transforms for W and as preconditioner. False if they
   * do not converge. Source: N. Gould, M. Hribar, J. Nocedal, On the solution
   * of equality constrained quadratic programming problems, SIAM J. Sci.
   * Comput. 23 (2001), the projected method; R. Pohrt, Q. Li, Facta Univ. Mech.
   * Eng. 12 (2014), transforms in contact.
   */
  bool solve_pressure_on_grid(const ContactProblem      &problem,
                              const std::vector<double> &gap,
                              const std::vector<bool>   &active,
                              ContactState              &state);

  /**
   * What solve_pressure_on_grid() leaves of gaps, over the largest
   * displacement.
   */
  constexpr double gap_left_on_grid = 1e-13;
} // namespace RollingContact

#endif
