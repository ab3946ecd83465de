#ifndef rolling_contact_distributed_distributed_theta_system_h
#define rolling_contact_distributed_distributed_theta_system_h

#include <rolling_contact/distributed/distributed_body.h>
#include <rolling_contact/dynamics/theta_system.h>

namespace RollingContact
{
  /**
   * Matrices of the theta-scheme for a distributed body: K, M and, for a time
   * step h,
   *   A = M + theta h C + theta^2 h^2 K
   * with conjugate gradients to solve with A; and on one rank the ThetaSystem
   * of the body's model, for the contact compliance. Shared by all states of
   * the body. Functions are collective unless they only return a value.
   */
  template <int dim>
  class DistributedThetaSystem
  {
  public:
    using SurfaceNode = typename ElasticBody<dim>::SurfaceNode;

    DistributedThetaSystem(const DistributedBody<dim>      &body,
                           const ThetaScheme               &scheme,
                           const MassKind                   mass,
                           const std::vector<SurfaceNode>  &nodes,
                           const std::vector<unsigned int> &components);

    /**
     * Assemble A for steps of this length, unless it is there. Units: s.
     */
    void
    set_time_step(const double h);

    /**
     * Length of the step that A belongs to; 0 before set_time_step(). Units: s.
     */
    double
    time_step() const
    {
      return h;
    }

    const ThetaScheme &
    scheme() const
    {
      return parameters;
    }

    /**
     * Contact compliance h^2 E^T A^-1 E of the model; on its rank, empty on
     * others. Units: m/N.
     */
    const DenseMatrix &
    contact_compliance() const;

    /**
     * Degrees of freedom of the contact nodes, component by component.
     */
    const std::vector<dealii::types::global_dof_index> &
    contact_dofs() const
    {
      return contact;
    }

    void
    multiply_stiffness(const DistributedVector &x,
                       DistributedVector       &result) const;

    void
    multiply_mass(const DistributedVector &x, DistributedVector &result) const;

    /**
     * Solve A x = b, from the guess in @p x, and return the number of
     * iterations.
     */
    unsigned int
    solve(DistributedVector &x, const DistributedVector &b) const;

    /**
     * The rigid motion e_z, zero at clamped nodes. Units: 1.
     */
    const DistributedVector &
    rise() const
    {
      return modes[dim - 1]; // translations come first
    }

    /**
     * Memory of this rank in bytes.
     */
    BodyDynamics::Memory
    memory_consumption() const;

  private:
    /**
     * A += factor M.
     */
    void
    add_mass(const double factor);

    ThetaScheme                                  parameters;
    std::vector<dealii::types::global_dof_index> contact;
    std::vector<DistributedVector>               modes;
    dealii::TrilinosWrappers::SparseMatrix       K, A;
    dealii::TrilinosWrappers::SparseMatrix       consistent; ///< M if so
    DistributedVector                            lumped;     ///< M if so
    bool                                         is_lumped;
    std::unique_ptr<MultigridSolver>             multigrid;
    std::unique_ptr<ThetaSystem>                 model;
    DenseMatrix                                  nothing;
    double                                       h = 0.;
  };
} // namespace RollingContact

#endif
