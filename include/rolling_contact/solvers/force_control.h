#ifndef rolling_contact_solvers_force_control_h
#define rolling_contact_solvers_force_control_h

#include <rolling_contact/solvers/contact_solver.h>

#include <functional>

namespace RollingContact
{
  /**
   * Derivative of the forces of a state by its creepages, both those of the
   * components that ContactLoads::forces asks for: dF_k / dxi_l of the contact
   * laws linearised on the touching nodes, exact but for how the edge law
   * changes with the state. Empty if the laws are singular there. Units: N, N m
   * over 1, 1/m.
   */
  DenseMatrix
  force_derivative(const ContactProblem &problem,
                   const SolverControls &controls,
                   const ContactState   &state);

  /**
   * How far creepages found for asked forces are off if forces and moment are
   * off by so small a part of mu N and of the moment of pure spin, in the order
   * of the components: along the law that G below makes linear, away from 0.
   * Empty if friction may not carry what is asked for then, or the creepages
   * are not decided by it. Units: 1 to 1, 1/m.
   */
  std::vector<double>
  creepage_margins(const ContactProblem &problem,
                   const SolverControls &controls,
                   const ContactState   &state,
                   const double          part);

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
  SolverReport
  solve_for_forces(const std::function<SolverReport()> &solve,
                   const SolverControls                &controls,
                   ContactProblem                      &problem,
                   ContactState                        &state);
} // namespace RollingContact

#endif
