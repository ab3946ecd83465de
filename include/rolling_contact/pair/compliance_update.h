#ifndef rolling_contact_pair_compliance_update_h
#define rolling_contact_pair_compliance_update_h

#include <rolling_contact/solvers/contact_solver.h>

#include <functional>

namespace RollingContact
{
  /**
   * W r of the bodies for several sets of nodal forces, tangential components
   * first; to all digits, or roughly. Units: N to m.
   */
  using PairResponse = std::function<std::vector<std::vector<double>>(
    const std::vector<std::vector<double>> &forces,
    const bool                              roughly)>;

  /**
   * Solve a contact problem between bodies whose compliance is known
   * approximately, and whose true response W r to the nodal forces r of the
   * state can be had at a price. Corrections from outside: solve with the
   * approximate W, ask for the response, let W give it from now on (see
   * ContactOperators::correct()), until the contact laws hold with the true
   * response to the tolerance of @p controls. W keeps what it learned. The
   * contact laws are solved on one rank and the state is given to all.
   */
  SolverReport
  solve_updating_compliance(const ContactSolver  &solver,
                            const PairResponse   &response,
                            const bool            exact,
                            const SolverControls &controls,
                            ContactProblem       &problem,
                            ContactState         &state);
} // namespace RollingContact

#endif
