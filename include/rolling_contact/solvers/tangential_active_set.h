#ifndef rolling_contact_solvers_tangential_active_set_h
#define rolling_contact_solvers_tangential_active_set_h

#include <rolling_contact/solvers/contact_solver.h>

namespace RollingContact
{
  /**
   * Primal-dual active set for Coulomb friction in 2D: zero slip on the stick
   * nodes, q = -+ mu p on the others, sets from q - rho_t s. Exact and finite;
   * rho_t is halved when the sets repeat (Alart and Curnier 1991, Hueber and
   * Wohlmuth 2005). In 3D, where discs replace intervals, semismooth Newton.
   */
  class TangentialActiveSet : public TangentialSolver
  {
  public:
    using TangentialSolver::TangentialSolver;

    SolverReport solve(const TangentialProblem &problem,
                       ContactState            &state) const override;
  };
} // namespace RollingContact

#endif
