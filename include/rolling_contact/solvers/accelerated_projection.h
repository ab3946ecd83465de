#ifndef rolling_contact_solvers_accelerated_projection_h
#define rolling_contact_solvers_accelerated_projection_h

#include <rolling_contact/solvers/contact_solver.h>

namespace RollingContact
{
  /**
   * The fixed point q = Proj(q - rho_t s) of Lai et al. 2017 for the traction,
   * accelerated by the last few changes (Anderson 1965, Walker and Ni 2011),
   * and projected again. One product with W per iteration.
   */
  class AcceleratedProjection : public TangentialSolver
  {
  public:
    using TangentialSolver::TangentialSolver;

    SolverReport solve(const TangentialProblem &problem,
                       ContactState            &state) const override;
  };
} // namespace RollingContact

#endif
