#ifndef rolling_contact_bodies_direct_body_h
#define rolling_contact_bodies_direct_body_h

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/bodies/contact_vibration.h>
#include <rolling_contact/bodies/elastic_body.h>

namespace RollingContact
{
  class ThetaSystem;

  /**
   * A body on one rank whose K is factorised: the compliance is exact, a
   * response and recovery are two triangular solves each.
   */
  template <int dim>
  class DirectBody : public ElasticBody<dim>
  {
  public:
    using typename ElasticBody<dim>::SurfaceNode;
    using ElasticBody<dim>::compliance;
    using typename ElasticBody<dim>::SurfaceFace;
    using StepSystem = ThetaSystem;

    /**
     * Mesh and number the unknowns. Unless the body @p recovers displacements,
     * the factor of K is freed as soon as the compliance is known and recover()
     * throws. Sleepers and a mass at the hub bring unknowns of their own, the
     * last ones; values at unknowns and fields hold these as well.
     */
    DirectBody(const std::shared_ptr<const BodyShape> &shape,
               const Materials                        &materials,
               const double                            thickness,
               const Grading<dim>                     &grading,
               const bool                              recovers = true,
               const BodyModel                        &model    = {});

    const DirectBody *with_factor() const override
    {
      return this;
    }

    void analyse() override;

    /**
     * Exact compliance; K is factorised on first use.
     */
    DenseMatrix compliance(const std::vector<SurfaceNode>  &nodes,
                           const std::vector<unsigned int> &components,
                           const SparseRows                &P) override;

    std::vector<std::vector<double>>
    response(const std::vector<SurfaceNode>         &nodes,
             const std::vector<unsigned int>        &components,
             const std::vector<std::vector<double>> &forces,
             const bool                              roughly) override;

    std::vector<BodyField>
    recover(const std::vector<SurfaceNode>         &nodes,
            const std::vector<unsigned int>        &components,
            const std::vector<std::vector<double>> &forces) override;

    std::unique_ptr<BodyDynamics>
    in_time(const ThetaScheme               &scheme,
            const MassKind                   mass,
            const std::vector<SurfaceNode>  &nodes,
            const std::vector<unsigned int> &components) override;

    void release_solver() override
    {
      factor.reset();
    }

    void release_factor() override
    {
      if (factor)
        factor->release();
    }

    /**
     * How contact nodes belong to vibrations of all unknowns, numbered as in
     * compliance().
     */
    virtual std::unique_ptr<ContactVibration>
    vibration_of(const std::vector<SurfaceNode>  &nodes,
                 const std::vector<unsigned int> &components) const;

    std::size_t n_unknowns() const override
    {
      return unknown_of_dof.size() - n_constrained;
    }

    std::string description() const override;

    std::size_t solver_memory() const override;

    double solver_seconds() const override;

    /**
     * K^-1 of several columns; K is factorised on first use.
     */
    DenseMatrix solve(DenseMatrix columns);

    /**
     * Stiffness K of the unknowns, assembled anew. Units: N/m.
     */
    SymmetricSparseMatrix stiffness() const;

    /**
     * Mass M of the unknowns. Units: kg.
     */
    SymmetricSparseMatrix mass(const MassKind kind = MassKind::lumped) const;

    /** The lumped masses of clamped nodes. */
    std::vector<PointMass> clamped_masses() const;

    /**
     * Loss stiffness, the sum of eta_i K_i over material, foundation and
     * ballast: the imaginary part of the stiffness in the frequency domain.
     * Units: N/m.
     */
    SymmetricSparseMatrix loss_stiffness() const;

    /**
     * Viscous damping C: Rayleigh's and that of absorbing ends, which take
     * a(x) of the lumped mass; without loss factors. Zero on the diagonal where
     * there is none. Units: N s/m.
     */
    SymmetricSparseMatrix damping(const MassKind kind = MassKind::lumped) const;

    /**
     * Damping in time, damping() + loss_stiffness() / (2 pi f0) with the loss
     * frequency f0; of size 0 if there is none. Units: N s/m.
     */
    SymmetricSparseMatrix
    damping_in_time(const MassKind kind = MassKind::lumped) const;

    /**
     * The matrix of flow round an axle, see assemble_rotation(), in 3D. Units:
     * kg.
     */
    SkewSparseMatrix rotation(const Axle &axle) const;

    /**
     * The factor of K, after compliance() and before it is released. Throws
     * std::logic_error if there is none.
     */
    const Factorisation &factorisation() const;

    /**
     * The node of each unknown, for the order of elimination.
     */
    const std::vector<unsigned int> &nodes_of_unknowns() const
    {
      return node_of_unknown;
    }

    /**
     * Numbers of the unknowns of contact: that of component @p components[i] at
     * node n of N is entry i * N + n.
     */
    std::vector<std::size_t>
    unknowns(const std::vector<SurfaceNode>  &nodes,
             const std::vector<unsigned int> &components) const;

    /**
     * Values at the unknowns of a field that is @p value in one component and
     * zero in the others, away from a clamped hub; masses move with it and do
     * not turn.
     */
    std::vector<double> uniform(const unsigned int component,
                                const double       value) const;

    /**
     * The rigid motion uniform() along z. Units: 1.
     */
    std::vector<double> rise() const
    {
      return uniform(dim - 1, 1.);
    }

    /**
     * M v with the lumped mass. Units: m/s to kg m/s.
     */
    std::vector<double>
    lumped_momentum(const std::vector<double> &velocity) const;

    /**
     * The field of given unknowns on all nodes, hanging and clamped ones
     * included, and behind them the extra unknowns of the supports.
     */
    BodyField field(const std::vector<double> &values) const;

    /**
     * The unknowns of a field on all nodes, the inverse of field().
     */
    std::vector<double> unknowns_of(const BodyField &field) const;

    /**
     * Forces at the unknowns, which work as forces on nodes along a component
     * do, hanging and clamped ones included. @p nodes: force at the first
     * degree of freedom of each node. Units: N.
     */
    std::vector<double> loads_of_nodes(const BodyField   &nodes,
                                       const unsigned int component) const;

    /**
     * Numbers of the unknowns in the order of BodyMotion, see
     * in_portable_order().
     */
    std::vector<std::size_t> portable_dof_order() const;

    /**
     * Displacement and velocity of the unknowns in the order of BodyMotion.
     * Units: m, m/s.
     */
    BodyMotion in_portable_order(const std::vector<double> &displacement,
                                 const std::vector<double> &velocity) const;

    /**
     * The inverse of in_portable_order(), for a motion of the right size.
     */
    std::pair<std::vector<double>, std::vector<double>>
    from_portable_order(const BodyMotion &motion) const;

  private:
    Discretisation<dim> discretisation() const;

    bool has_losses() const;

    /**
     * The damping of the absorbing ends, a diagonal. Units: N s/m.
     */
    std::vector<double> sponge() const;

    const bool                     recovers;
    std::vector<int>               unknown_of_dof; ///< -1 if constrained
    std::vector<unsigned int>      node_of_unknown;
    std::size_t                    n_constrained = 0;
    std::unique_ptr<Factorisation> factor;
  };
} // namespace RollingContact

#endif
