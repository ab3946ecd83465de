#ifndef rolling_contact_bodies_distributed_body_h
#define rolling_contact_bodies_distributed_body_h

#include <rolling_contact/algebra/multigrid_solver.h>
#include <rolling_contact/bodies/direct_body.h>
#include <rolling_contact/bodies/distributed_dof_order.h>

namespace RollingContact
{
  template <int dim>
  class DistributedThetaSystem;

  /**
   * A body spread over all ranks: a mesh by p4est, K solved by conjugate
   * gradients with algebraic multigrid. Its compliance() is approximated by
   * that of a model on one rank: a DirectBody with the same elements at the
   * contact, which grow faster away from it. Forces and displacements of
   * contact nodes are the same on all ranks, and functions are collective
   * unless they say otherwise.
   */
  template <int dim>
  class DistributedBody : public ElasticBody<dim>
  {
  public:
    using typename ElasticBody<dim>::SurfaceNode;
    using ElasticBody<dim>::compliance;
    using typename ElasticBody<dim>::SurfaceFace;
    using StepSystem = DistributedThetaSystem<dim>;

    /**
     * Mesh the body; @p model_rank will hold its model. Thickness in 2D. Units:
     * m. Throws InputError for springs or a mass at the hub.
     */
    DistributedBody(const std::shared_ptr<const BodyShape> &shape,
                    const Materials                        &materials,
                    const double                            thickness,
                    const Grading<dim>                     &grading,
                    const unsigned int                      model_rank,
                    const BodyModel                        &model = {});

    void analyse() override;

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

    void release_solver() override;

    std::size_t n_unknowns() const override
    {
      return total_unknowns;
    }

    std::string description() const override;

    std::size_t solver_memory() const override;

    double solver_seconds() const override;

    /**
     * What matrices of the body are assembled from. Not collective.
     */
    DistributedDiscretisation<dim> discretisation() const
    {
      return {this->dofs,
              this->relevant_dofs,
              this->constraints,
              this->materials,
              this->thickness,
              this->model.elements};
    }

    /**
     * A zero vector of the degrees of freedom of this rank, without ghosts.
     */
    DistributedVector vector() const
    {
      return DistributedVector(this->dofs.locally_owned_dofs(),
                               this->dofs.get_communicator());
    }

    /**
     * The rigid motions of the body, see rigid_motions(), about the contact
     * point and scaled by the thickness of the body.
     */
    std::vector<DistributedVector> rigid_modes() const;

    /**
     * The rigid motion along z, zero at clamped nodes. Units: 1.
     */
    DistributedVector rise() const
    {
      return rigid_modes()[dim - 1]; // translations come first
    }

    /**
     * M v with the lumped mass. Units: m/s to kg m/s.
     */
    DistributedVector lumped_momentum(DistributedVector velocity) const
    {
      velocity.scale(lumped_mass(discretisation()));
      return velocity;
    }

    /**
     * Add nodal forces on the degrees of freedom of @p contact to @p b; each
     * rank adds those it owns. Units: N. Not collective.
     */
    void add_forces(const std::vector<dealii::types::global_dof_index> &contact,
                    const std::vector<double>                          &forces,
                    DistributedVector &b) const;

    /**
     * Values at the degrees of freedom of @p contact, on all ranks.
     */
    std::vector<double>
    on_contact(const std::vector<dealii::types::global_dof_index> &contact,
               const DistributedVector &values) const;

    /**
     * Degrees of freedom of contact nodes: that of component @p components[i]
     * at node n stands at i * N + n. Not collective.
     */
    static std::vector<dealii::types::global_dof_index>
    contact_dofs(const std::vector<SurfaceNode>  &nodes,
                 const std::vector<unsigned int> &components);

    /**
     * The field of a solution: with values at hanging nodes and ghosts.
     */
    BodyField field(const DistributedVector &solution) const;

    /**
     * The values of a field, zero at constrained nodes. Not collective.
     */
    DistributedVector unknowns_of(const BodyField &field) const
    {
      DistributedVector result = vector();
      result.copy_locally_owned_data_from(field);
      for (const auto dof : result.locally_owned_elements())
        if (this->constraints.is_constrained(dof))
          result(dof) = 0.;
      return result;
    }

    /**
     * Displacement and velocity in the order of BodyMotion, on the first rank
     * and empty on others. Units: m, m/s.
     */
    BodyMotion in_portable_order(const DistributedVector &displacement,
                                 const DistributedVector &velocity) const
    {
      return RollingContact::in_portable_order(discretisation(),
                                               displacement,
                                               velocity);
    }

    /**
     * The inverse of in_portable_order(), for a motion of the right size.
     */
    std::pair<DistributedVector, DistributedVector>
    from_portable_order(const BodyMotion &motion) const
    {
      return RollingContact::from_portable_order(discretisation(), motion);
    }

    /**
     * Mesh the model on its rank; nullptr on others. Not collective.
     */
    std::unique_ptr<DirectBody<dim>> make_model() const;

    /**
     * The contact nodes of the model, which lie at @p nodes of the body. Not
     * collective.
     */
    std::vector<SurfaceNode>
    model_nodes(const DirectBody<dim>          &model,
                const std::vector<SurfaceNode> &nodes) const;

  private:
    /**
     * Displacement of the whole body under nodal forces, from solutions that
     * are known where they tell it. Units: N to m.
     */
    BodyField recovered(const std::vector<SurfaceNode>  &nodes,
                        const std::vector<unsigned int> &components,
                        const std::vector<double>       &forces);

    /**
     * Solve K x = b for several sets of forces on the degrees of freedom of
     * @p contact, to a relative residual of @p tolerance. As many solutions
     * begin with the vectors in @p x as there are, the others with zero.
     */
    void solve(const std::vector<dealii::types::global_dof_index> &contact,
               const std::vector<std::vector<double>>             &forces,
               const double                                        tolerance,
               std::vector<DistributedVector>                     &x);

    const std::shared_ptr<const BodyShape> shape;
    const Grading<dim>                     grading;
    const unsigned int                     model_rank;
    std::size_t                            total_unknowns = 0;

    dealii::TrilinosWrappers::SparseMatrix K;
    std::unique_ptr<MultigridSolver>       multigrid;
    /** The last loads that were solved for to all digits. */
    std::vector<std::vector<double>> loads;
    std::vector<DistributedVector>   solutions;
    unsigned int                     n_solves        = 0;
    unsigned int                     n_iterations    = 0;
    unsigned int                     most_iterations = 0;
    /** Wall seconds, and CPU seconds of this rank. */
    double solve_s = 0., model_s = 0., assembly_cpu_s = 0., setup_cpu_s = 0.,
           solve_cpu_s           = 0.;
    std::size_t n_model_unknowns = 0;
  };
} // namespace RollingContact

#endif
