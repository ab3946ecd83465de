#ifndef rolling_contact_contact_contact_operators_h
#define rolling_contact_contact_contact_operators_h

#include <rolling_contact/algebra/nodal_field.h>
#include <rolling_contact/contact/contact_compliance.h>
#include <rolling_contact/contact/slip_operator.h>
#include <rolling_contact/contact/surface_frames.h>

#include <array>
#include <vector>

namespace RollingContact
{
  /**
   * How displacements enter the slip, flow B1 (convection w) + rate B2 w:
   * steady rolling has convection 1 and rate 0; a time step h at speed V has
   * rate 1/(h |V|) and the convection of the displacement of its scheme.
   */
  struct TimeScaling
  {
    double convection = 1.;
    double rate       = 0.; ///< 1/m

    friend bool operator==(const TimeScaling &a, const TimeScaling &b)
    {
      return a.convection == b.convection && a.rate == b.rate;
    }
  };

  /**
   * Whether the normal and tangential displacements of the bodies depend on
   * each other.
   */
  struct NormalTangentialCoupling
  {
    bool   exists       = true; ///< false if W_nt = 0 exactly
    double dundurs_beta = 0.;   ///< of the materials, for the edge law

    /// 1 / (1 - nu): what a line of traction along itself moves a half-space,
    /// over what it moves it as a line of pressure.
    double antiplane_share = 1.;
  };

  /**
   * What W takes a nodal force for: one of linear elements of the bodies, or a
   * hat of traction on half-spaces, whose displacement is that at the nodes.
   */
  enum class NodalForces
  {
    of_elements,
    hats
  };

  /**
   * What the bodies, their interface and the scheme in time make of the contact
   * problem, whatever its loads: compliance W, contact matrix H, slip operator
   * B1 on N paired nodes with T = 0 (frictionless), 1 (2D) or 2 (3D) tangential
   * components, and the quantities derived from them. Complete once built; W
   * and the scaling in time change through functions that renew all that
   * depends on them. W is a dense matrix but in steady rolling on a grid. Knows
   * no mesh.
   */
  class ContactOperators
  {
  public:
    using Positions = std::vector<std::array<double, 2>>;

    ContactOperators() = default;

    /**
     * @p positions are (x, y) of the nodes in m, y along the surface of
     * contact, @p H has N rows (m^2) and @p W (T + 1) N (m/N), tangential
     * components first, normal last. The surface of contact is a plane.
     */
    ContactOperators(Positions                       positions,
                     SparseRows                      H,
                     ContactCompliance               W,
                     SlipOperator                    slip_operator = {},
                     const NormalTangentialCoupling &coupling      = {},
                     const NodalForces forces = NodalForces::of_elements);

    /**
     * Replace W.
     */
    void set_compliance(ContactCompliance W);

    /**
     * Replace convection and rate, 1 and 0 in operators just built.
     */
    void set_time_scaling(const TimeScaling &scaling);

    /**
     * Replace the frames of the surface of contact.
     */
    void set_frames(SurfaceFrames frames);

    /**
     * Make W, an approximate one, give the @p displacement of the bodies under
     * nodal @p forces, (T + 1) N values with the tangential components first,
     * by the smallest symmetric change that keeps what W gave for earlier
     * forces: with d = displacement - W forces, W += d d^T / (forces . d), or,
     * where that is not positive enough, the symmetric change of rank two of
     * smallest norm (Powell). Without coupling the tangential and the normal
     * block change by themselves. A d of less than 1e-11 of the displacement is
     * the error of the response and changes nothing. The norms stay as they
     * are: residuals before and after corrections are measured alike. Units: N
     * to m.
     */
    void correct(const std::vector<double> &forces,
                 const std::vector<double> &displacement);

    /**
     * True once W was corrected since it was set.
     */
    bool is_corrected() const
    {
      return corrected;
    }

    unsigned int n_nodes() const
    {
      return contact_matrix.size();
    }

    unsigned int n_tangential() const
    {
      return n_tangential_components;
    }

    const Positions &positions() const
    {
      return node_positions;
    }

    NodalForces nodal_forces() const
    {
      return forces;
    }

    const SurfaceFrames &frames() const
    {
      return surface_frames;
    }

    /**
     * The place of a node in the plane of creepages and resultants, (x, y).
     * Units: m.
     */
    std::array<double, 2> place(const unsigned int i) const;

    /**
     * What share of the approach of the bodies closes the gap of a node, and of
     * its normal force is load: the cosine between its normal and the direction
     * of both; 1 in a plane.
     */
    double approach_share(const unsigned int i) const
    {
      return shares.empty() ? 1. : shares[i];
    }

    /**
     * The load of unit pressure at each node, H^T of the approach_share():
     * areas() in a plane. Units: m^2.
     */
    const std::vector<double> &load_areas() const
    {
      return shares.empty() ? node_areas : areas_of_load;
    }

    /**
     * The load of a pressure. Units: Pa to N.
     */
    double load(const std::vector<double> &pressure) const;

    const SparseRows &H() const
    {
      return contact_matrix;
    }

    /**
     * Column @p j of H.
     */
    const SparseRows::Row &H_column(const unsigned int j) const
    {
      return H_columns[j];
    }

    const ContactCompliance &W() const &
    {
      return compliance;
    }

    ContactCompliance W() &&
    {
      return std::move(compliance);
    }

    /**
     * W_nn H, the normal displacements of unit nodal pressures, of a dense W.
     * Units: m/Pa.
     */
    const DenseMatrix &pressure_compliance() const
    {
      return W_nn_H;
    }

    const SlipOperator &slip_operator() const
    {
      return B1;
    }

    const NormalTangentialCoupling &coupling() const
    {
      return normal_tangential;
    }

    const TimeScaling &time_scaling() const
    {
      return scaling;
    }

    /**
     * Convection times the direction of the flow, +1 or -1.
     */
    double flow_convection() const
    {
      return B1.flow_direction() * scaling.convection;
    }

    /**
     * Row sums of H. Units: m^2.
     */
    const std::vector<double> &areas() const
    {
      return node_areas;
    }

    /**
     * Largest singular value of W_nn H, to three digits. Units: m/Pa.
     */
    double normal_norm() const
    {
      return largest_normal;
    }

    /**
     * Largest singular value of (flow convection B1 + rate) W_tt H, to three
     * digits; zero without friction. Units: 1/Pa.
     */
    double tangential_norm() const
    {
      return largest_tangential;
    }

    /**
     * Normal displacement W_nn H p under a pressure. Units: Pa to m.
     */
    std::vector<double>
    normal_displacement(const std::vector<double> &pressure) const;

    /**
     * Normal displacement W_nt H q under a traction, zero when uncoupled.
     * Units: Pa to m.
     */
    std::vector<double>
    normal_displacement_of_traction(const NodalField &traction) const;

    /**
     * Tangential displacement W_tt H q under a traction. Units: Pa to m.
     */
    NodalField tangential_displacement(const NodalField &traction) const;

    /**
     * Tangential displacement W_tn H p under a pressure, zero when uncoupled.
     * Units: Pa to m.
     */
    NodalField tangential_displacement_of_pressure(
      const std::vector<double> &pressure) const;

    /**
     * Tangential displacement W_tt H q + W_tn H p under traction and pressure.
     * Units: Pa to m.
     */
    NodalField
    tangential_displacement(const NodalField          &traction,
                            const std::vector<double> &pressure) const;

    /**
     * Displacement W_cc H f in the direction of component @p c under a scalar
     * @p field used as the traction in that direction. Units: Pa to m.
     */
    std::vector<double>
    displacement_along(const unsigned int         c,
                       const std::vector<double> &field) const;

    /**
     * Displacement W_tt H q as the slip needs it: in steady rolling every
     * component without the displacement of one node. The displacement of a
     * rigid motion, which B1 does not see, may be many orders of magnitude
     * larger than what is left, and is never added up. With a rate B2 sees
     * rigid motions, and nothing is left out. Units: Pa to m.
     */
    NodalField distortion_of_traction(const NodalField &traction) const;

    /**
     * Displacement W_tn H p as the slip needs it, see distortion_of_traction().
     */
    NodalField
    distortion_of_pressure(const std::vector<double> &pressure) const;

    /**
     * The tangential distortion under a unit traction at a node, or a unit
     * pressure: component T. Units: m/Pa.
     */
    NodalField distortion_of_unit(const NodalIndex &unit) const;

    /**
     * Sum of the nodal forces H f of a scalar field, such as the load of a
     * pressure. Units: Pa to N.
     */
    double resultant(const std::vector<double> &field) const;

    /**
     * First row and column of W's normal block.
     */
    std::size_t first_normal() const
    {
      return n_tangential_components * contact_matrix.size();
    }

  private:
    NodalField distortion(const std::size_t          first_column,
                          const std::vector<double> &forces) const;

    NodalField distortion_by_columns(const std::size_t          first_column,
                                     const std::vector<double> &forces) const;

    void find_pressure_compliance();

    void find_normal_norm();

    void find_tangential_norm();

    unsigned int             n_tangential_components = 0;
    Positions                node_positions;
    SparseRows               contact_matrix, H_columns;
    ContactCompliance        compliance;
    DenseMatrix              W_nn_H;
    SlipOperator             B1;
    NormalTangentialCoupling normal_tangential;
    NodalForces              forces = NodalForces::of_elements;
    TimeScaling              scaling;
    SurfaceFrames            surface_frames;
    std::vector<double>      shares; ///< of the approach; empty for ones
    std::vector<double>      node_areas, areas_of_load;
    double                   largest_normal = 0., largest_tangential = 0.;
    bool                     corrected = false;
  };
} // namespace RollingContact

#endif
