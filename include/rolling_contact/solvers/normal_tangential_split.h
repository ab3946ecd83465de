#ifndef rolling_contact_solvers_normal_tangential_split_h
#define rolling_contact_solvers_normal_tangential_split_h

#include <rolling_contact/solvers/contact_solver.h>

namespace RollingContact
{
  /**
   * Alternates exact normal and exact tangential solves until the natural
   * residual of both laws is below the tolerance: one pass when W_nt = 0; with
   * coupling, Anderson acceleration on the traction once ten passes were not
   * enough. A tangential solver that fails is followed by the next one given.
   * All that again with the edge extrapolations the traction asks for, until
   * these settle, see SchemeRounds; where they do not, the edges of both last
   * rounds keep theirs.
   * Reported as `active set`.
   */
  class NormalTangentialSplit : public ContactSolver
  {
  public:
    NormalTangentialSplit(
      std::unique_ptr<NormalSolver>                  normal,
      std::vector<std::unique_ptr<TangentialSolver>> tangential,
      const SolverControls                          &controls,
      const bool                                     economical = false);

    SolverReport solve(const ContactProblem &problem,
                       ContactState         &state) const override;

  private:
    /**
     * Solve for the traction by the first that succeeds of the first @p
     * n_solvers tangential solvers; false if none does.
     */
    bool solve_with_any(const TangentialProblem &problem,
                        const std::size_t        n_solvers,
                        ContactState            &state,
                        SolverReport            &report) const;

    /**
     * Tolerance of a round after which the edge extrapolations will change by
     * about as much as before, by @p change.
     */
    double tolerance_of_round(const ContactProblem &problem,
                              const double          change) const;

    /**
     * Alternate normal and tangential solves, with the edge extrapolations of
     * the state, until the residual is at most @p tolerance. Returns those the
     * traction asks for, none where it fails.
     */
    SlipScheme alternate(const ContactProblem &problem,
                         const std::size_t     n_solvers,
                         const double          tolerance,
                         ContactState         &state,
                         SolverReport         &report) const;

    std::unique_ptr<NormalSolver>                  normal;
    std::vector<std::unique_ptr<TangentialSolver>> tangential;
    SolverControls                                 controls;
    bool economical; ///< in the rounds of the edge law
  };
} // namespace RollingContact

#endif
