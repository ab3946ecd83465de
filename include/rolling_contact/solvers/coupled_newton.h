#ifndef rolling_contact_solvers_coupled_newton_h
#define rolling_contact_solvers_coupled_newton_h

#include <rolling_contact/solvers/contact_solver.h>

namespace RollingContact
{
  /**
   * Semismooth Newton for pressure, traction and approach at once, steps damped
   * by the natural residual: for mu times the coupling W_nt so large that
   * solves in turn move apart. The touching nodes share
   *   u_n = 0,      s = 0 where |z| <= b,      q = b z/|z| where |z| > b
   * with z = q - rho_t s and b = mu (p - rho_n u_n). The rows of the edge law
   * are those of the present pressure.
   */
  class CoupledNewton : public ContactSolver
  {
  public:
    explicit CoupledNewton(const SolverControls &controls)
      : controls(controls)
    {}

    SolverReport solve(const ContactProblem &problem,
                       ContactState         &state) const override;

  private:
    SolverControls controls;
  };
} // namespace RollingContact

#endif
