#ifndef rolling_contact_contact_contact_problem_h
#define rolling_contact_contact_contact_problem_h

#include <rolling_contact/base/creepages.h>
#include <rolling_contact/contact/friction_law.h>
#include <rolling_contact/interface/slip_operator.h>
#include <rolling_contact/linear_algebra/dense_matrix.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * Everything the contact laws need, on N paired nodes and with the bodies
   * reduced to their compliance. T = 0 (frictionless), 1 (2D) or 2 (3D)
   * tangential components; nodal fields of T components are stored component by
   * component. Knows no mesh and no solver.
   *
   * Pressure p >= 0 and traction q act on the wheel, -p and -q on the rail:
   *   u_n = gap - approach + W_nn H p + W_nt H q                      (m)
   *   w   = W_tt H q + W_tn H p                                      (m)
   *   s   = rigid_slip + free_slip
   *         + flow B1 (free_displacement + convection w) + rate w     (1)
   *   p = Proj_{>=0}(p - rho_n u_n),  q = Proj_{|.| <= mu p}(q - rho_t s)
   * eqs. (8) and (12) of Lai et al. 2017. Steady rolling has convection 1 and
   * no rate; a time step h at speed V has the rate 1/(h |V|) of (1/V) B2, and
   * what the step does without reactions in gap, free_slip and
   * free_displacement. With a friction law mu falls with the sliding speed |s|
   * |V|, s the slip that the traction answers, and p, q, s and mu hold at once.
   */
  struct ContactProblem
  {
    unsigned int n_nodes      = 0;
    unsigned int n_tangential = 0;

    std::vector<std::array<double, 2>> positions; ///< (x, y), m

    DenseMatrix W; ///< m/N; tangential components first, normal last
    bool        coupled           = true;  ///< false if W_nt = 0 exactly
    bool   smooth_modes_corrected = false; ///< an approximate W was corrected
    double dundurs_beta           = 0.; ///< of the materials, for the edge law
    SparseRows          H;              ///< m^2
    std::vector<double> areas;          ///< row sums of H, m^2
    std::vector<double> gap;            ///< undeformed, m
    std::vector<double> friction;       ///< mu of each node, mu_s if it falls
    Creepages           creepages;      ///< rigid_slip comes from them
    std::vector<double> rigid_slip;     ///< T N values

    std::vector<double> free_slip;         ///< T N values, empty for zero
    std::vector<double> free_displacement; ///< T N values, empty for zero; m
    double              convection = 1.;
    double              rate       = 0.; ///< 1/m

    SlipOperator slip_operator;

    std::shared_ptr<const FrictionLaw> friction_law; ///< none: mu is constant
    double                             speed = 0.;   ///< |V| for it, m/s

    std::optional<double> normal_load; ///< N; the approach is unknown if given
    double                approach = 0.; ///< m

    double normal_norm     = 0.; ///< largest eigenvalue of W_nn H, m/Pa
    double tangential_norm = 0.; ///< ||(convection B1 + rate) W_tt H||, 1/Pa

    /**
     * Complete the fields derived from W and H: areas and norms, by power
     * iteration.
     */
    void
    finish();

    /**
     * pressure_compliance(), for a changed W.
     */
    void
    update_pressure_compliance();

    /**
     * tangential_norm, for a new convection or rate.
     */
    void
    find_tangential_norm();

    /**
     * Column @p j of H.
     */
    const SparseRows::Row &
    H_column(const unsigned int j) const
    {
      return H_columns[j];
    }

    /**
     * Keep these creepages and set the rigid slip of the nodes by them.
     */
    void
    set_creepages(const Creepages &values);

    /**
     * W_nn H p.
     */
    std::vector<double>
    normal_displacement(const std::vector<double> &pressure) const;

    /**
     * W_nt H q, zero when uncoupled.
     */
    std::vector<double>
    normal_displacement_of_traction(const std::vector<double> &traction) const;

    /**
     * W_tt H q.
     */
    std::vector<double>
    tangential_displacement(const std::vector<double> &traction) const;

    /**
     * W_tn H p, zero when uncoupled.
     */
    std::vector<double>
    tangential_displacement_of_pressure(
      const std::vector<double> &pressure) const;

    /**
     * W_tt H q + W_tn H p.
     */
    std::vector<double>
    tangential_displacement(const std::vector<double> &traction,
                            const std::vector<double> &pressure) const;

    /**
     * The same, in every component without the displacement of one
     * node. That of a rigid motion, which B1 does not see, may be many orders
     * of magnitude larger than what is left, and is never added up.
     */
    std::vector<double>
    tangential_distortion(const std::vector<double> &traction,
                          const std::vector<double> &pressure) const;

    /**
     * Tangential displacement under a unit pressure (component n_tangential) or
     * traction at a node; a distortion as above, unless there is a rate: B2
     * sees rigid motions. Units: m/Pa.
     */
    std::vector<double>
    distortion_of_unit(const unsigned int node,
                       const unsigned int component) const;

    /**
     * W_nn H, the displacement of unit nodal pressures.
     */
    const DenseMatrix &
    pressure_compliance() const
    {
      return W_nn_H;
    }

    /**
     * Sum of nodal forces H f of one component. Units: N.
     */
    double
    resultant(const std::vector<double> &nodal_field,
              const unsigned int         component = 0) const;

  private:
    DenseMatrix W_nn_H;
    SparseRows  H_columns;
  };

  /**
   * What the edge law asks of the first node of a line of touching nodes, by
   * the next two: g1 = second g2 - third g3 + rest, g = (q - q_n) / p. See
   * edge_law.h.
   */
  struct EdgeExtrapolation
  {
    unsigned int          first  = 0; ///< node
    double                second = 1.;
    double                third  = 0.;
    std::array<double, 2> rest{{0., 0.}}; ///< for each tangential component
  };

  /**
   * The unknowns: pressure and traction at the nodes, and the approach when the
   * load is given. Units: Pa, m.
   */
  struct ContactState
  {
    std::vector<double>            pressure;
    std::vector<double>            traction;
    double                         approach = 0.;
    std::vector<EdgeExtrapolation> edges;           ///< where not g1 = g2
    bool                           edge_law = true; ///< if B1 has one
    std::vector<double>            friction;        ///< mu it was solved with
    bool holds_friction = false; ///< whatever the slip: to solve for the rest
  };

  /**
   * No pressure, no traction.
   */
  ContactState
  open_state(const ContactProblem &problem);

  /**
   * A line of touching nodes from its leading edge on, in the order of the
   * flow, with the fields of the edge law for each tangential component. Units:
   * m, Pa.
   */
  struct ContactEdge
  {
    std::vector<unsigned int>          nodes;
    std::vector<double>                along;     ///< coordinates
    std::array<std::vector<double>, 2> companion; ///< of p
    std::array<std::vector<double>, 2> coupling;  ///< q_n
  };

  /**
   * The frictional half of the problem for a given pressure: traction bound,
   * the slip operators that belong to this pressure, and the slip at q = 0. The
   * edge law takes some rows of B1 and B2 between nodes.
   */
  struct TangentialProblem
  {
    TangentialProblem(const ContactProblem                 &contact,
                      const std::vector<double>            &pressure,
                      const std::vector<EdgeExtrapolation> &extrapolations,
                      const bool                            edge_law = true);

    /**
     * What the friction law acts on, s(q) = slip_at_zero + slip_of(W_tt H q) +
     * edge_rows q.
     */
    std::vector<double>
    slip(const std::vector<double> &traction) const;

    /**
     * The slip of the surfaces: s(q) without the edge law's term.
     */
    std::vector<double>
    material_slip(const std::vector<double> &traction) const;

    /**
     * ds/dq of some of the T N @p unknowns in both directions, a dense matrix
     * for solvers that factorise parts of it. Units: 1/Pa.
     */
    DenseMatrix
    slip_compliance(const std::vector<std::size_t> &unknowns) const;

    /**
     * |s| |V| of the nodes that carry friction, 0 elsewhere. Units: m/s.
     */
    std::vector<double>
    sliding_speeds(const std::vector<double> &slip) const;

    /**
     * mu of the friction law at this slip; as it is without a law.
     */
    std::vector<double>
    friction_at(const std::vector<double> &slip) const;

    /**
     * Take these nodal mu.
     */
    void
    set_friction(const std::vector<double> &coefficients);

    /**
     * Project the nodal tractions onto the discs |q| <= bound.
     */
    void
    project(std::vector<double> &traction) const;

    /**
     * Nodal forces of q - Proj(q - rho_t s), rho_t one over tangential_norm,
     * summed and divided by mu N; zero without friction.
     */
    double
    residual(const std::vector<double> &traction,
             const std::vector<double> &slip) const;

    /**
     * What a displacement w adds to the slip, flow B1 (convection w) + rate
     * B2 w. Units: m to 1.
     */
    std::vector<double>
    slip_of(const std::vector<double> &w) const;

    /**
     * Tangential displacement under one of traction and pressure, the other
     * empty; what B1 does not see is left out where B2 has no share. Units: m.
     */
    std::vector<double>
    displacement(const std::vector<double> &traction,
                 const std::vector<double> &pressure) const;

    const ContactProblem &contact;
    SparseRows            B1;
    SparseRows            B2;           ///< where the law holds: at the nodes
    std::vector<double>   friction;     ///< mu of each node
    std::vector<double>   bound;        ///< mu p, Pa
    std::vector<double>   slip_at_zero; ///< T N values

    std::vector<SparseRows>  edge_rows;      ///< for each component, 1/Pa
    std::vector<double>      edge_constants; ///< their share at q = 0, or empty
    std::vector<ContactEdge> edges;
  };

  /**
   * H q and H p of a state, tangential components first. Units: N.
   */
  std::vector<double>
  nodal_forces(const ContactProblem &contact, const ContactState &state);

  /**
   * u_n of a state.
   */
  std::vector<double>
  normal_gap(const ContactProblem &contact, const ContactState &state);

  /**
   * Natural residual of the contact laws, the same for every solver: nodal
   * forces of p - Proj(p - rho_n u_n) and q - Proj(q - rho_t s), with rho one
   * over the operator norms, summed and divided by N and mu N.
   */
  struct NaturalResidual
  {
    double normal     = 0.;
    double tangential = 0.;

    /**
     * The larger of them, infinite if either is not a number.
     */
    double
    worst() const;
  };

  NaturalResidual
  natural_residual(const ContactProblem    &contact,
                   const TangentialProblem &tangential,
                   const ContactState      &state);

  /**
   * The frictional half at the pressure and with the edge law of a state, mu
   * that of the friction law at the state's own slip unless the state holds it.
   */
  TangentialProblem
  tangential_problem(const ContactProblem &contact, const ContactState &state);
} // namespace RollingContact

#endif
