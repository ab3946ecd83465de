#ifndef rolling_contact_solvers_extragradient_h
#define rolling_contact_solvers_extragradient_h

#include <rolling_contact/solvers/contact_solver.h>

namespace RollingContact
{
  /**
   * Projection and correction with an adapted step, q1 = Proj(q - rho s(q)),
   * q = Proj(q - rho s(q1)): converges for any monotone slip operator, in 2D
   * and 3D (Korpelevich 1976, Khobotov 1987). Two products with W per
   * iteration.
   */
  class Extragradient : public TangentialSolver
  {
  public:
    using TangentialSolver::TangentialSolver;

    SolverReport solve(const TangentialProblem &problem,
                       ContactState            &state) const override;
  };
} // namespace RollingContact

#endif
