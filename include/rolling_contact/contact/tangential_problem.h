#ifndef rolling_contact_contact_tangential_problem_h
#define rolling_contact_contact_tangential_problem_h

#include <rolling_contact/contact/edge_law.h>

namespace RollingContact
{
  /**
   * The frictional half of the contact problem for a given pressure: traction
   * bound mu p, the rows of the slip operators that belong to this pressure,
   * and the slip
   *
   *   s(q) = slip_at_zero + slip_of(W_tt H q) + edge rows q + edge constants
   *
   * on which q = Proj_{|.| <= mu p}(q - rho_t s) acts. Holds a reference to the
   * whole problem.
   */
  struct TangentialProblem
  {
    TangentialProblem(const ContactProblem      &contact,
                      const std::vector<double> &pressure,
                      const SlipScheme          &scheme,
                      const bool                 edge_law = true);

    /**
     * Slip s(q) that the friction law acts on. Units: Pa to 1.
     */
    NodalField slip(const NodalField &traction) const;

    /**
     * The slip of the surfaces: s(q) without the terms of the edge law.
     */
    NodalField material_slip(const NodalField &traction) const;

    /**
     * The slip of the surfaces in the mean around each node, with
     * SlipOperator::mean_derivative() in place of B1: the sum over the nodes of
     * A_i q_i times it is the power of friction, singular slips at the edges of
     * the patch and between nodes included. It does not tell stick from slip.
     */
    NodalField mean_slip(const ContactState &state) const;

    /**
     * Derivative ds/dq of some of the T N @p unknowns in both directions, a
     * dense matrix for solvers that factorise parts of it. Units: 1/Pa.
     */
    DenseMatrix slip_compliance(const std::vector<NodalIndex> &unknowns) const;

    /**
     * Sliding speed |s| |V| of the nodes that carry friction, 0 elsewhere.
     * Units: m/s.
     */
    std::vector<double> sliding_speeds(const NodalField &slip) const;

    /**
     * Nodal mu of the friction law at a slip; without a law the present mu.
     */
    std::vector<double> friction_at(const NodalField &slip) const;

    /**
     * Replace mu of the nodes, and with it the bound.
     */
    void set_friction(const std::vector<double> &coefficients);

    /**
     * Project the nodal tractions onto the discs |q| <= bound.
     */
    void project(NodalField &traction) const;

    /**
     * Trial traction q - rho_t s, rho_t one over tangential_norm. Units: Pa.
     */
    NodalField trial(const NodalField &traction, const NodalField &slip) const;

    /**
     * Nodal forces of q - Proj(q - rho_t s), rho_t one over tangential_norm,
     * summed and divided by mu N; zero without friction.
     */
    double residual(const NodalField &traction, const NodalField &slip) const;

    /**
     * What a tangential displacement w adds to the slip, flow B1 (convection w)
     * + rate B2 w. Units: m to 1.
     */
    NodalField slip_of(const NodalField &w) const;

    /**
     * Slip by slip_of() in one component at one node. Units: m to 1.
     */
    double slip_of(const NodalField &w, const NodalIndex &at) const;

    const ContactProblem &contact;
    SlipRows              rows;
    std::vector<double>   friction;     ///< mu of each node
    std::vector<double>   bound;        ///< mu p, Pa
    NodalField            slip_at_zero; ///< without the edge law's constants
  };

  /**
   * The frictional half at the pressure and with the edge law of a state, mu
   * that of the friction law at the state's own slip unless the state holds it.
   */
  TangentialProblem tangential_problem(const ContactProblem &contact,
                                       const ContactState   &state);

  /**
   * Natural residual of the contact laws, measured alike for every solver:
   * nodal forces of p - Proj(p - rho_n u_n) and q - Proj(q - rho_t s), with rho
   * one over the operator norms, summed and divided by N and mu N. N is the
   * given load, to which the difference of sum p is added, or else the sum of
   * p. If that is not positive the normal residual is the sum of forces itself
   * (N): zero for open contact without overlap. The tangential residual is zero
   * without friction or traction bound.
   */
  struct NaturalResidual
  {
    double normal     = 0.;
    double tangential = 0.;

    /**
     * The larger of both residuals, infinite if either is not a number.
     */
    double worst() const;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[normal, tangential] = *this;
      archive &normal &tangential;
    }
  };

  NaturalResidual natural_residual(const ContactProblem    &contact,
                                   const TangentialProblem &tangential,
                                   const ContactState      &state);
} // namespace RollingContact

#endif
