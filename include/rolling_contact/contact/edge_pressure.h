#ifndef rolling_contact_contact_edge_pressure_h
#define rolling_contact_contact_edge_pressure_h

#include <rolling_contact/contact/touching_run.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * The tangentially equivalent pressure in one tangential component on one run
   * of touching nodes, and the traction that answers the coupling: discrete
   * fields next to the leading edge that move the surface by a smooth amount
   * more than the pressure moves it along the normal.
   *
   * Half-spaces answer p(x) along the flow as they do along the normal, w_t =
   * w_n. Bodies of finite size add a smooth amount, and finite elements one at
   * the scale of an element, as their compliances in both directions differ
   * there. The smooth amount acts on g = q / p as rigid slip does; that of the
   * elements would be taken for a traction. The equivalent pressure is free of
   * it: the field with the smallest correction for which w_t - w_n, less its
   * smooth part, is quadratic in x on a window behind the edge. The smooth part
   * is a polynomial through the nodes that the edges do not disturb. As w_n
   * follows the gap, waves of the surface are in both and leave no correction.
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

    const std::vector<unsigned int> &nodes() const
    {
      return run.nodes;
    }

    unsigned int component() const
    {
      return direction;
    }

    /**
     * Coordinate of node @p k of the run along the flow. Units: m.
     */
    double along(const std::size_t k) const
    {
      return x[k];
    }

    /**
     * Compliance (W_tt H)_kj between two nodes of the run, in this component.
     * Units: m/Pa.
     */
    double compliance(const std::size_t k, const std::size_t j) const;

    /**
     * The nodes across the flow around the first node over the length of its
     * element: the first node alone unless elements are more than twice as long
     * as wide.
     */
    std::vector<unsigned int> across_first() const;

    /**
     * How much less a traction at the nodes across the first one moves the
     * second node than the first. Units: m/Pa.
     */
    double fall_of_compliance() const;

    /**
     * The values of a scalar nodal field on the run.
     */
    std::vector<double> on_run(const std::vector<double> &nodal) const;

    /**
     * The pressure on the run that is tangentially equivalent to the nodal
     * @p pressure; @p surplus is what it moves the surface in this component as
     * the traction beyond what it moves it as a pressure, at all nodes. On runs
     * too short for a window and where the fit is singular, the pressure
     * itself. The smooth part is a polynomial of @p degree; if that is empty,
     * of one that is found by what it leaves, and then given. Units: Pa, m.
     */
    std::vector<double> equivalent(const std::vector<double>   &pressure,
                                   const std::vector<double>   &surplus,
                                   std::optional<unsigned int> &degree) const;

    std::vector<double> equivalent(const std::vector<double> &pressure,
                                   const std::vector<double> &surplus) const
    {
      std::optional<unsigned int> degree;
      return equivalent(pressure, surplus, degree);
    }

    /**
     * The largest relative correction of an equivalent pressure away from the
     * edge, where there should be none. Units: 1.
     */
    double irregularity(const std::vector<double> &equivalent,
                        const std::vector<double> &pressure) const;

    /**
     * Coupling traction q_n on the run, the traction that answers the part of
     * the tangential displacement of the pressure that is not smooth: beta/pi p
     * ln((x - x_l)/(x_r - x)) + its correction, beta Dundurs'; without beta
     * what meshes of unlike bodies differ by at the scale of an element. What
     * bodies of unlike shape add is smooth, and acts as rigid slip does. Zero
     * without coupling, on lines of less than ten nodes or that end inside the
     * contact, and across the flow. @p moved_along: what the pressure moves all
     * nodes along x; @p degree: as in equivalent(). Units: Pa, m.
     */
    std::vector<double>
    coupling_traction(const std::vector<double>   &pressure,
                      const std::vector<double>   &moved_along,
                      std::optional<unsigned int> &degree) const;

  private:
    /**
     * How many nodes from the edge the window holds; 0 if the run is too short.
     */
    std::size_t window() const;

    /**
     * What the correction of each node of the window is measured in. Units: Pa.
     */
    std::vector<double>
    correction_scales(const std::size_t          n_window,
                      const std::vector<double> &pressure) const;

    /**
     * A displacement of the run without the smooth part that bodies of finite
     * size add to it, a polynomial of this @p degree, or if that is empty of at
     * least the degree @p lowest, if there are nodes enough.
     */
    std::vector<double>
    without_smooth_part(std::vector<double>          displacement,
                        const unsigned int           lowest,
                        std::optional<unsigned int> &degree) const;

    /**
     * Correct @p field, whose displacement with all else that moves the surface
     * is @p displacement. All three on the run.
     */
    void smooth(const std::vector<double> &displacement,
                const std::vector<double> &pressure,
                std::vector<double>       &field) const;

    const ContactOperators &operators;
    const TouchingRun      &run;
    unsigned int            direction;
    int                     flow;
    std::vector<double>     x; ///< along the flow
  };
} // namespace RollingContact

#endif
