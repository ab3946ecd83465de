#ifndef rolling_contact_solvers_semismooth_newton_h
#define rolling_contact_solvers_semismooth_newton_h

#include <rolling_contact/solvers/contact_solver.h>

namespace RollingContact
{
  /**
   * Semismooth Newton iteration on q = Proj(q - rho_t s(q)), the active set of
   * discs: where |z| <= mu p, z = q - rho_t s, the step asks for zero slip,
   * elsewhere it follows the projection q = mu p z/|z| and its derivative
   * (Alart and Curnier 1991). One dense solve on the touching nodes per
   * iteration; the step is damped by the natural residual, and where that has
   * stopped falling a few extragradient steps from the best state lead
   * elsewhere. Gives up after four such rescues.
   */
  class SemismoothNewton : public TangentialSolver
  {
  public:
    using TangentialSolver::TangentialSolver;

    SolverReport solve(const TangentialProblem &problem,
                       ContactState            &state) const override;

  private:
    /**
     * Take that many extragradient steps, or fewer; returns how many were
     * taken.
     */
    unsigned int rescue(const TangentialProblem &problem,
                        const unsigned int       n_steps,
                        ContactState            &state) const;
  };
} // namespace RollingContact

#endif
