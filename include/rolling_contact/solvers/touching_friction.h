#ifndef rolling_contact_solvers_touching_friction_h
#define rolling_contact_solvers_touching_friction_h

#include <rolling_contact/contact/tangential_problem.h>

#include <vector>

namespace RollingContact
{
  /**
   * The frictional problem in 3D on the nodes that may carry traction alone,
   * both components of a node side by side. On a grid slips are found by
   * Fourier transforms, and only their derivatives along lines of the flow are
   * known as matrices.
   */
  class TouchingFriction
  {
  public:
    explicit TouchingFriction(const TangentialProblem &problem);

    /**
     * Nodes of a line along the flow.
     */
    struct Line
    {
      std::vector<std::size_t> first; ///< of the two tractions of each node
      DenseMatrix              slip_compliance; ///< two rows a node, 1/Pa
    };

    bool is_on_grid() const
    {
      return slip_compliance.size() == 0;
    }

    /**
     * Slips of tractions. Units: Pa to 1.
     */
    std::vector<double> slip(const std::vector<double> &traction) const;

    /**
     * What a change of tractions does to the slips. Units: Pa to 1.
     */
    std::vector<double>
    change_of_slip(const std::vector<double> &traction) const;

    /**
     * Cut the nodal tractions back to the traction bound.
     */
    void project(std::vector<double> &traction) const;

    /**
     * The natural residual, over mu N.
     */
    double residual(const std::vector<double> &traction) const;

    std::vector<double> gathered(const NodalField &field) const;

    void scatter(const std::vector<double> &values, NodalField &field) const;

    const TangentialProblem &problem;
    std::vector<NodalIndex>  unknowns;
    DenseMatrix              slip_compliance; ///< 1/Pa, empty on a grid
    std::vector<Line>        lines;           ///< on a grid
    double                   norm;            ///< 1/Pa
    double                   friction_force;  ///< N
    std::vector<double>      slip_at_zero, bound, area;

  private:
    void make_lines();
  };
} // namespace RollingContact

#endif
