#ifndef rolling_contact_solvers_normal_active_set_h
#define rolling_contact_solvers_normal_active_set_h

#include <rolling_contact/solvers/contact_solver.h>

namespace RollingContact
{
  /**
   * Primal-dual active set for p >= 0, u_n >= 0: solve with u_n = 0 on the
   * active nodes, drop those that pull, add those that overlap. Two to six
   * dense solves; when the sets repeat, single exchanges by least index, which
   * end for every positive definite W_nn (Murty 1974).
   */
  class NormalActiveSet : public NormalSolver
  {
  public:
    using NormalSolver::NormalSolver;

    SolverReport solve(const ContactProblem &problem,
                       ContactState         &state) const override;
  };
} // namespace RollingContact

#endif
