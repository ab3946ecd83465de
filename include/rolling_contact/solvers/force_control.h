#ifndef rolling_contact_solvers_force_control_h
#define rolling_contact_solvers_force_control_h

#include <rolling_contact/solvers/contact_solver.h>

#include <functional>

namespace RollingContact
{
  /**
   * Find the creepages of @p problem at which its state has the asked forces,
   * from those that it has, where @p solve solves it for given creepages.
   * Newton for G(F(xi)) = G(asked) with force_derivative() and
   *   G(F) = m (1 - (1 - |F|)^(1/m)) F / |F|,  F over mu N (moments over that
   *   of pure spin), m = 2 in 2D, 3 in 3D,
   * which is linear in the creepage for Carter's law and that of Vermeulen and
   * Johnson. Steps that do not come closer are halved. Done when the forces are
   * 1e-9 of mu N off, or a tenth of the tolerance of the residual. Throws
   * InputError if friction cannot carry them.
   */
  SolverReport solve_for_forces(const std::function<SolverReport()> &solve,
                                const SolverControls                &controls,
                                ContactProblem                      &problem,
                                ContactState                        &state);
} // namespace RollingContact

#endif
