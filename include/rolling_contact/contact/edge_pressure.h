#ifndef rolling_contact_contact_edge_pressure_h
#define rolling_contact_contact_edge_pressure_h

#include <rolling_contact/contact/contact_problem.h>

namespace RollingContact
{
  /**
   * Consecutive touching nodes of a line, in the order of the flow.
   */
  struct TouchingRun
  {
    std::vector<unsigned int> nodes;
    bool leading = true;  ///< the point one element upstream is open
    bool cut     = false; ///< the line ends inside the contact
  };

  /**
   * All runs of touching nodes on the lines of the slip operator.
   */
  std::vector<TouchingRun>
  touching_runs(const SlipOperator        &slip_operator,
                const std::vector<double> &pressure);

  /**
   * The tangentially equivalent pressure in one tangential component on one run
   * of touching nodes, and the traction that answers the coupling: discrete
   * fields next to the leading edge that move the surface by a smooth amount.
   *
   * The compliances of finite elements in the normal and in a tangential
   * direction differ at the scale of an element, so the discrete pressure, used
   * as a traction, does not move the surface tangentially by a smooth amount.
   * The equivalent pressure does: it is the field with the smallest correction
   * whose displacement is quadratic in x on a window behind the edge.
   * Corrections belong next to the edge and to changes of the element size:
   * that of node k is measured in
   *
   *   p_k [0.03 + sum_e (h_e / max(h_e, |x_k - x_e|))^3]
   *
   * over the edge and the changes e, h_e the (larger) element size there.
   */
  class EdgePressure
  {
  public:
    /**
     * Holds references to @p contact and @p run.
     */
    EdgePressure(const ContactProblem &contact,
                 const TouchingRun    &run,
                 const unsigned int    component);

    const std::vector<unsigned int> &
    nodes() const
    {
      return run.nodes;
    }

    unsigned int
    component() const
    {
      return direction;
    }

    /**
     * Coordinate of node @p k of the run along the flow. Units: m.
     */
    double
    along(const std::size_t k) const
    {
      return flow * operators.positions()[run.nodes[k]][0];
    }

    /**
     * Compliance (W_tt H)_kj between two nodes of the run, in this component.
     * Units: m/Pa.
     */
    double
    compliance(const std::size_t k, const std::size_t j) const;

    /**
     * The values of a scalar nodal field on the run.
     */
    std::vector<double>
    on_run(const std::vector<double> &nodal) const;

    /**
     * The pressure on the run that is tangentially equivalent to the nodal
     * @p pressure; @p displacement is that of the pressure used as the traction
     * of this component, at all nodes. On runs too short for a window and where
     * the fit is singular, the pressure itself. Units: Pa, m.
     */
    std::vector<double>
    equivalent(const std::vector<double> &pressure,
               const std::vector<double> &displacement) const;

    /**
     * Coupling traction q_n on the run, the traction that answers the
     * tangential displacement of the pressure near the edge: beta/pi p ln((x -
     * x_l)/(x_r - x)) + its correction, beta Dundurs'. Zero without coupling,
     * on lines of less than ten nodes or that end inside the contact, and
     * across the flow. Units: Pa.
     */
    std::vector<double>
    coupling_traction(const std::vector<double> &pressure) const;

  private:
    /**
     * How many nodes from the edge the window holds; 0 if the run is too short.
     */
    std::size_t
    window() const;

    /**
     * What the correction of each node of the window is measured in. Units: Pa.
     */
    std::vector<double>
    correction_scales(const std::size_t          n_window,
                      const std::vector<double> &pressure) const;

    /**
     * Correct @p field, whose displacement with all else that moves the surface
     * is @p displacement. All three on the run.
     */
    void
    smooth(const std::vector<double> &displacement,
           const std::vector<double> &pressure,
           std::vector<double>       &field) const;

    const ContactOperators &operators;
    const TouchingRun      &run;
    unsigned int            direction;
    int                     flow;
  };
} // namespace RollingContact

#endif
