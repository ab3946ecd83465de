#ifndef rolling_contact_contact_edge_companion_h
#define rolling_contact_contact_edge_companion_h

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

  std::vector<TouchingRun>
  touching_runs(const SlipOperator        &slip_operator,
                const std::vector<double> &pressure);

  /**
   * One tangential component on one run of touching nodes: the discrete
   * companions of continuous fields near the leading edge.
   *
   * The compliances of finite elements in the normal and in a tangential
   * direction differ at the scale of an element, so the discrete pressure is
   * not the traction that moves the surface tangentially by a smooth amount.
   * Its companion is: the field with the smallest correction whose displacement
   * is quadratic in x on a window behind the edge. Corrections belong next to
   * the edge and to changes of the element size: that of node k is measured in
   *
   *   p_k [0.03 + sum_e (h_e / max(h_e, |x_k - x_e|))^3]
   *
   * over the edge and the changes e, h_e the (larger) element size there; 0.03
   * leaves room for the rough pressures of nearly incompressible elements.
   */
  class EdgeCompanion
  {
  public:
    EdgeCompanion(const ContactProblem &contact,
                  const TouchingRun    &run,
                  const unsigned int    component);

    /**
     * Coordinate of node @p k of the run along the flow. Units: m.
     */
    double
    along(const std::size_t k) const
    {
      return flow * contact.positions[run.nodes[k]][0];
    }

    /**
     * (W_tt H)_kj of two nodes of the run. Units: m/Pa.
     */
    double
    compliance(const std::size_t k, const std::size_t j) const;

    /**
     * A nodal field on the run.
     */
    std::vector<double>
    on_run(const std::vector<double> &nodal) const;

    /**
     * The companion of @p pressure on the run; @p displacement is that of the
     * pressure used as the traction of this component, T N values. Units: Pa.
     */
    std::vector<double>
    pressure(const std::vector<double> &pressure,
             const std::vector<double> &displacement) const;

    /**
     * q_n on the run, the traction that answers the tangential displacement of
     * the pressure near the edge: beta/pi p ln((x - x_l)/(x_r - x)) + its
     * correction, beta Dundurs'. Zero without coupling, on lines of less than
     * ten nodes or that end inside the contact, and across the flow. Units: Pa.
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
     * What the correction of each node of the window is measured in, Pa.
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

    const ContactProblem &contact;
    const TouchingRun    &run;
    unsigned int          component;
    int                   flow;
  };

  /**
   * W_tt H f for a field given on the nodes and used as the traction of one
   * component, T N values. Units: m.
   */
  std::vector<double>
  displacement_of(const ContactProblem      &contact,
                  const std::vector<double> &field,
                  const unsigned int         component);
} // namespace RollingContact

#endif
