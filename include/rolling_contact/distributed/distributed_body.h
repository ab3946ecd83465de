#ifndef rolling_contact_distributed_distributed_body_h
#define rolling_contact_distributed_distributed_body_h

#include <rolling_contact/distributed/distributed_matrices.h>
#include <rolling_contact/elasticity/direct_body.h>
#include <rolling_contact/linear_algebra/multigrid_solver.h>


namespace RollingContact
{
  /**
   * A body spread over all ranks: a mesh by p4est, K solved by conjugate
   * gradients with algebraic multigrid. Its compliance is that of a model on
   * one rank: the same body with the same elements at the contact, growing
   * faster away from it, whose K is factorised.
   */
  template <int dim>
  class DistributedBody : public ElasticBody<dim>
  {
  public:
    using typename ElasticBody<dim>::SurfaceNode;
    using typename ElasticBody<dim>::SurfaceFace;

    /**
     * Mesh over all ranks; the model of the compliance lives on @p model_rank.
     */
    DistributedBody(const std::shared_ptr<const BodyShape> &shape,
                    const Material                         &material,
                    const double                            thickness,
                    const Grading<dim>                     &grading,
                    const unsigned int                      model_rank);

    void
    analyse() override;

    DenseMatrix
    compliance(const std::vector<SurfaceNode>  &nodes,
               const std::vector<unsigned int> &components) override;

    std::vector<std::vector<double>>
    response(const std::vector<SurfaceNode>         &nodes,
             const std::vector<unsigned int>        &components,
             const std::vector<std::vector<double>> &forces,
             const bool                              roughly) override;

    BodyField
    recover(const std::vector<SurfaceNode>  &nodes,
            const std::vector<unsigned int> &components,
            const std::vector<double>       &forces) override;

    std::unique_ptr<BodyDynamics>
    in_time(const ThetaScheme               &scheme,
            const MassKind                   mass,
            const std::vector<SurfaceNode>  &nodes,
            const std::vector<unsigned int> &components) override;

    void
    release_solver() override;

    std::size_t
    n_unknowns() const override
    {
      return total_unknowns;
    }

    std::string
    description() const override;

    std::size_t
    solver_memory() const override;

    double
    solver_seconds() const override;

    DistributedDiscretisation<dim>
    discretisation() const
    {
      return {this->dofs,
              this->relevant_dofs,
              this->constraints,
              this->material,
              this->thickness};
    }

    /**
     * A vector of the degrees of freedom of this rank, without ghosts.
     */
    DistributedVector
    vector() const
    {
      return DistributedVector(this->dofs.locally_owned_dofs(),
                               this->dofs.get_communicator());
    }

    std::vector<DistributedVector>
    rigid_modes() const;

    /**
     * Add nodal forces to @p b at the contact nodes of this rank. Units: N.
     */
    void
    add_forces(const std::vector<dealii::types::global_dof_index> &contact,
               const std::vector<double>                          &forces,
               DistributedVector                                  &b) const;

    /**
     * Values at the contact nodes, on all ranks.
     */
    std::vector<double>
    on_contact(const std::vector<dealii::types::global_dof_index> &contact,
               const DistributedVector &values) const;

    /**
     * Degrees of freedom of contact: that of component @p components[i] at node
     * n of N is entry i * N + n.
     */
    static std::vector<dealii::types::global_dof_index>
    contact_dofs(const std::vector<SurfaceNode>  &nodes,
                 const std::vector<unsigned int> &components);

    /**
     * The field of a solution, with hanging nodes and ghosts.
     */
    BodyField
    field(const DistributedVector &solution) const;

    /**
     * The model of the compliance on its rank; nullptr on others.
     */
    std::unique_ptr<DirectBody<dim>>
    make_model() const;

    /**
     * The nodes of the model that lie where @p nodes of the body do, in their
     * order. Throws if there are others.
     */
    std::vector<SurfaceNode>
    model_nodes(const DirectBody<dim>          &model,
                const std::vector<SurfaceNode> &nodes) const;

  private:
    /**
     * Solutions for loads by conjugate gradients, from the guesses in @p x as
     * far as there are any.
     */
    void
    solve(const std::vector<dealii::types::global_dof_index> &contact,
          const std::vector<std::vector<double>>             &forces,
          const double                                        tolerance,
          std::vector<DistributedVector>                     &x);

    const std::shared_ptr<const BodyShape> shape;
    const Grading<dim>                     grading;
    const unsigned int                     model_rank;
    std::size_t                            total_unknowns = 0;

    dealii::TrilinosWrappers::SparseMatrix K;
    std::unique_ptr<MultigridSolver>       multigrid;
    /** The last loads that were solved for, to all digits. */
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
