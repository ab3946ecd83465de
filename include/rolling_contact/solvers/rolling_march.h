#ifndef rolling_contact_solvers_rolling_march_h
#define rolling_contact_solvers_rolling_march_h

#include <rolling_contact/solvers/contact_solver.h>

#include <memory>

namespace RollingContact
{
  /**
   * Steady rolling as the end of a start from no traction: marches in rolled
   * distance, without inertia, and lets another solver solve the step h of
   *   s = s_0 + B1 w + (w - w_before)/h
   * then the steady problem from where it came to. Steps grow, and are halved
   * when one fails. Not for the problem of a time step.
   */
  class RollingMarch : public ContactSolver
  {
  public:
    RollingMarch(std::shared_ptr<const ContactSolver> step_solver,
                 const SolverControls                &controls)
      : step_solver(std::move(step_solver))
      , controls(controls)
    {}

    SolverReport solve(const ContactProblem &problem,
                       ContactState         &state) const override;

  private:
    std::shared_ptr<const ContactSolver> step_solver;
    SolverControls                       controls;
  };
} // namespace RollingContact

#endif
