#ifndef rolling_contact_solvers_compliance_update_h
#define rolling_contact_solvers_compliance_update_h

#include <rolling_contact/solvers/contact_solver.h>

#include <functional>

namespace RollingContact
{
  /**
   * Displacement W r of the bodies for each of several sets of nodal forces r,
   * tangential components first; to all digits, or @p roughly. Units: N to m.
   * Collective.
   */
  using PairResponse = std::function<std::vector<std::vector<double>>(
    const std::vector<std::vector<double>> &forces,
    const bool                              roughly)>;

  /**
   * Solve a contact problem between bodies whose compliance W is known
   * approximately, and whose true @p response to the nodal forces r of a state
   * costs body solves. This is a quasi-Newton method for W: solve the contact
   * laws with the approximate W, compute the response, update W by the secant
   * condition W r = response (see ContactOperators::correct()), and repeat
   * until the contact laws hold with the true response to the tolerance of @p
   * controls; once, without updates, if W is @p exact. The updates stay in the
   * W of
   * @p problem. The contact laws are solved on the root. Problem and state are
   * the same on all ranks, before and after, and so is the report. Collective.
   */
  SolverReport solve_updating_compliance(const ContactSolver  &solver,
                                         const PairResponse   &response,
                                         const bool            exact,
                                         const SolverControls &controls,
                                         ContactProblem       &problem,
                                         ContactState         &state);
} // namespace RollingContact

#endif
