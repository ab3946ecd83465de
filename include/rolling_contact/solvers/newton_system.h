#ifndef rolling_contact_solvers_newton_system_h
#define rolling_contact_solvers_newton_system_h

#include <rolling_contact/solvers/contact_solver.h>

#include <array>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * The contact laws linearised at a state, one linear system. Unknowns are
   * tangential components, then pressure, node by node on the touching nodes,
   * then the approach if the load is given. With z = q - rho_t s, b = mu (p -
   * rho_n u_n) and edge rows of the present pressure, touching nodes share
   *   u_n = 0,      s = 0 where |z| <= b,      q = b z/|z| where |z| > b.
   */
  class NewtonSystem
  {
  public:
    /**
     * What the unknowns are: the pressure may be left out where traction does
     * not change it.
     */
    enum class Unknowns
    {
      traction,
      traction_and_pressure
    };

    NewtonSystem(const ContactProblem &problem,
                 const SolverControls &controls,
                 const ContactState   &state,
                 const Unknowns unknowns = Unknowns::traction_and_pressure);

    /**
     * The state after a full step; false if the matrix is singular.
     */
    bool solve(ContactState &target);

    /**
     * How traction and pressure of a state that solves the problem change with
     * its rigid slip, for each of several changes @p slips of that, mu falling
     * with the slip where a friction law says so; approach and edge law's
     * constants are left as they are. Empty if the matrix is singular. Units: 1
     * to Pa.
     */
    std::vector<ContactState> response(const std::vector<NodalField> &slips);

    /**
     * How much linear functionals of traction and pressure of a state that
     * solves the problem change with the displacements of the bodies: for each
     * of several @p weights, those of the values of a state, the weights of
     * all displacements, component by component, the tangential ones first,
     * the gap's last. Edge law's constants are left as they are. Empty if the
     * matrix is singular. Units: those of the functional over Pa to those of
     * it over m.
     */
    std::vector<std::vector<double>>
    sensitivities(const std::vector<ContactState> &weights);

  private:
    std::size_t place(const std::size_t  touching,
                      const unsigned int component) const
    {
      return touching * n_components + component;
    }

    /**
     * Where a node slides, z over its length in @p direction; false where it
     * sticks. @p size is that length, @p bound b.
     */
    bool slides(const std::size_t      touching,
                std::array<double, 2> &direction,
                double                &size,
                double                &bound) const;

    double coefficient(const std::size_t touching) const;

    void add_columns();

    void add_column(const std::size_t touching, const unsigned int component);

    void add_edge_rows();

    /**
     * Turn the slip rows of a node into those of its friction law, mu falling
     * by @p fall with the slip. Units: 1.
     */
    void set_friction_rows(const std::size_t touching, const double fall);

    /**
     * The matrix of the laws linearised at the present state.
     */
    void linearise();

    /**
     * What a @p change of slip alone takes from the linearised friction law of
     * a node, a symmetric map: the change where it sticks, else what turns the
     * traction and lets mu fall. Units: those of the change.
     */
    std::array<double, 2>
    part_of_slip(const std::size_t            touching,
                 const std::array<double, 2> &change) const;

    void set_right(const std::size_t touching);

    void set_load_rows();

    /**
     * -dmu/d|s| of a node under the friction law. Units: 1.
     */
    double fall(const std::size_t touching) const;

    const ContactProblem &problem;
    ContactState          now; ///< nothing carried by nodes that do not touch
    TangentialProblem     friction;
    const double          rho_n, rho_t;
    const unsigned int    n_tangential, n_components;

    std::vector<unsigned int> nodes;
    std::vector<std::size_t>  number; ///< of a node among the touching ones
    std::vector<double>       u_n;
    NodalField                slip;
    std::vector<double>       immediate; ///< of friction with a memory
    DenseMatrix               matrix, right;
  };
} // namespace RollingContact

#endif
