#ifndef rolling_contact_solvers_falling_friction_h
#define rolling_contact_solvers_falling_friction_h

#include <rolling_contact/solvers/contact_solver.h>

#include <memory>

namespace RollingContact
{
  /**
   * Friction that falls with the sliding speed, around a solver for fixed mu of
   * each node. A round holds mu, solves, and takes mu of the friction law at
   * the slip found; the end is a state with mu of its own slip. Rounds begin
   * with the mu the state comes with, or with mu_s. Newton's step for mu is
   * tried first; where it does not halve the residual mu is replaced: less
   * friction means more slip and less friction again, so in short time steps
   * these rounds only fall (or rise) and end at the next solution on their way.
   * Where that does not settle mu goes half the way, then all begins from fast
   * sliding, which the report says. Without a friction law this is the other
   * solver and no more.
   */
  class FallingFriction : public ContactSolver
  {
  public:
    FallingFriction(std::unique_ptr<const ContactSolver> coulomb,
                    const SolverControls                &controls)
      : coulomb(std::move(coulomb))
      , controls(controls)
    {}

    SolverReport
    solve(const ContactProblem &problem, ContactState &state) const override;

  private:
    struct Round;

    /**
     * Rounds in which mu goes @p part of the way. Counts its work in @p report,
     * which tells whether it converged.
     */
    void
    settle(const ContactProblem &problem,
           const double          part,
           ContactState         &state,
           SolverReport         &report) const;

    /**
     * Solve with these mu, from the state of @p round and into it. False if
     * that fails.
     */
    bool
    solve_with(const std::vector<double> &friction,
               const ContactProblem      &problem,
               Round                     &round,
               SolverReport              &report) const;

    /**
     * Newton's step for mu from @p round; it stays where it was unless the
     * residual halves.
     */
    bool
    try_newton(const ContactProblem &problem,
               Round                &round,
               SolverReport         &report) const;

    std::unique_ptr<const ContactSolver> coulomb;
    SolverControls                       controls;
  };
} // namespace RollingContact

#endif
