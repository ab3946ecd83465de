#ifndef rolling_contact_solvers_scaled_forces_h
#define rolling_contact_solvers_scaled_forces_h

#include <rolling_contact/solvers/contact_solver.h>

#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * What straightens the saturation of forces F over what full sliding carries:
   *   G(F) = m (1 - (1 - |F|)^(1/m)) F / |F|
   * is linear in the creepage for Carter's law with m = 2 and for that of
   * Vermeulen and Johnson with m = 3. Continued by its tangent close to |F| =
   * 1.
   */
  class Saturation
  {
  public:
    explicit Saturation(const double m)
      : m(m)
    {}

    std::vector<double> value(const std::vector<double> &F) const;

    /**
     * dG/dF.
     */
    DenseMatrix derivative(const std::vector<double> &F) const;

  private:
    double growth(const double size) const;

    double grown(const double size) const;

    const double m;
    const double last = 1 - 1e-6;
  };

  /**
   * Derivative of the forces of a state by its creepages, both those of the
   * components that ContactLoads::forces asks for: dF_k / dxi_l of the contact
   * laws linearised on the touching nodes, exact but for how the edge law
   * changes with the state. Empty if the laws are singular there. Units: N, N m
   * over 1, 1/m.
   */
  DenseMatrix force_derivative(const ContactProblem &problem,
                               const SolverControls &controls,
                               const ContactState   &state);

  /**
   * mu N, and the moment of pure spin at full sliding, for the components that
   * are asked for; 1 without contact. Units: N, N m.
   */
  std::vector<double> force_scales(const ContactProblem &problem,
                                   const ContactState   &state);

  /**
   * Asked and present forces of friction alone over their scales.
   */
  std::pair<std::vector<double>, std::vector<double>>
  scaled_forces(const ContactProblem      &problem,
                const ContactState        &state,
                const std::vector<double> &scales);

  /**
   * force_derivative() of the scaled forces.
   */
  DenseMatrix scaled_derivative(const ContactProblem      &problem,
                                const SolverControls      &controls,
                                const ContactState        &state,
                                const std::vector<double> &scales);

  /**
   * How far creepages found for asked forces are off if forces and moment are
   * off by so small a part of mu N and of the moment of pure spin, in the order
   * of the components: along the law that G below makes linear, away from 0.
   * Empty if friction may not carry what is asked for then, or the creepages
   * are not decided by it. Units: 1 to 1, 1/m.
   */
  std::vector<double> creepage_margins(const ContactProblem &problem,
                                       const SolverControls &controls,
                                       const ContactState   &state,
                                       const double          part);
} // namespace RollingContact

#endif
