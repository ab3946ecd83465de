#ifndef rolling_contact_solvers_falling_friction_h
#define rolling_contact_solvers_falling_friction_h

#include <rolling_contact/solvers/contact_solver.h>

#include <memory>

namespace RollingContact
{
  /**
   * Velocity-dependent friction, which falls with the sliding speed, around a
   * solver for fixed mu of each node. An outer iteration holds mu, solves, and
   * takes mu of the friction law at the slip found; the end is a state with mu
   * of its own slip. The first mu is that of the given state, or mu_s. Newton's
   * step for mu is tried first; where it does not halve the residual mu is
   * replaced: less friction means more slip and less friction again, so in
   * short time steps these iterations only fall (or rise) and end at the next
   * solution on their way. Where that does not settle mu goes half the way,
   * then all begins from fast sliding, which the report says. Without a
   * friction law this is the other solver and no more.
   */
  class FallingFriction : public ContactSolver
  {
  public:
    FallingFriction(std::unique_ptr<const ContactSolver> fixed_mu_solver,
                    const SolverControls                &controls)
      : fixed_mu_solver(std::move(fixed_mu_solver))
      , controls(controls)
    {}

    SolverReport solve(const ContactProblem &problem,
                       ContactState         &state) const override;

  private:
    struct Iterate;

    /**
     * Iterate with @p part of the way in mu. Counts its work in @p report,
     * which tells whether it converged.
     */
    void settle(const ContactProblem &problem,
                const double          part,
                ContactState         &state,
                SolverReport         &report) const;

    /**
     * One outer iteration: solve with mu = @p friction, from the state of
     * @p iterate and into it. False if that fails.
     */
    bool solve_with(const std::vector<double> &friction,
                    const ContactProblem      &problem,
                    Iterate                   &iterate,
                    SolverReport              &report) const;

    /**
     * Try Newton's step for mu from @p iterate, which stays as it was, with
     * false returned, unless the residual halves.
     */
    bool try_newton(const ContactProblem &problem,
                    Iterate              &iterate,
                    SolverReport         &report) const;

    std::unique_ptr<const ContactSolver> fixed_mu_solver;
    SolverControls                       controls;
  };
} // namespace RollingContact

#endif
