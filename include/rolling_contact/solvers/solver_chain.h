#ifndef rolling_contact_solvers_solver_chain_h
#define rolling_contact_solvers_solver_chain_h

#include <rolling_contact/solvers/contact_solver.h>

#include <memory>

namespace RollingContact
{
  /**
   * The split into normal and tangential solves and, where it fails, what is
   * left to try: Newton for pressure and traction at once, both without the
   * edge law, and for steady rolling the march in rolled distance. The report
   * names what was used.
   */
  class SolverChain : public ContactSolver
  {
  public:
    SolverChain(std::shared_ptr<const ContactSolver> split,
                const SolverControls                &controls);

    SolverReport solve(const ContactProblem &problem,
                       ContactState         &state) const override;

  private:
    /**
     * Try a solver; its effort goes into the report and, if it succeeds, its
     * name there and its solution into @p state.
     */
    bool attempt(const ContactSolver  &solver,
                 const ContactProblem &problem,
                 ContactState          from,
                 SolverReport         &report,
                 ContactState         &state) const;

    std::shared_ptr<const ContactSolver> split, newton;
    SolverControls                       controls;
  };
} // namespace RollingContact

#endif
