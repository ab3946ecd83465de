#ifndef rolling_contact_solvers_fixed_point_h
#define rolling_contact_solvers_fixed_point_h

#include <rolling_contact/solvers/contact_solver.h>

namespace RollingContact
{
  /**
   * The iteration of Lai et al. 2017, section 3.3: both laws (8) applied to the
   * reactions at once, p = Proj(p - rho_n u_n), q = Proj(q - rho_t s). Linear
   * in speed, and in steady partial slip without convergence for most rho: kept
   * as the reference method. A given load is held by the approach that makes
   * each projected pressure carry it.
   */
  class FixedPoint : public ContactSolver
  {
  public:
    explicit FixedPoint(const SolverControls &controls)
      : controls(controls)
    {}

    SolverReport solve(const ContactProblem &problem,
                       ContactState         &state) const override;

  private:
    SolverControls controls;
  };
} // namespace RollingContact

#endif
