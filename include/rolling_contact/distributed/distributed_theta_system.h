#ifndef rolling_contact_distributed_distributed_theta_system_h
#define rolling_contact_distributed_distributed_theta_system_h

#include <rolling_contact/distributed/distributed_body.h>
#include <rolling_contact/dynamics/theta_system.h>

namespace RollingContact
{
  /**
   * What ThetaSystem is, for a distributed body: K, M and, for a time step h,
   *   A = M + theta h C + theta^2 h^2 K
   * with conjugate gradients to solve with it; and on one rank the ThetaSystem
   * of the body's model, for its contact compliance. Shared by all states of
   * the body.
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
     * Units: s.
     */
    void
    set_time_step(const double h);

    /**
     * 0 before set_time_step().
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
     * h^2 E^T A^-1 E of the model, on its rank. Units: m/N.
     */
    const DenseMatrix &
    contact_compliance() const;

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
     * A x = b, from the guess in @p x; the number of iterations.
     */
    unsigned int
    solve(DistributedVector &x, const DistributedVector &b) const;

    /**
     * The rigid motion e_z, zero where the body is held.
     */
    const DistributedVector &
    rise() const
    {
      return modes[dim - 1]; // translations come first
    }

    /**
     * Bytes on this rank.
     */
    BodyDynamics::Memory
    memory_consumption() const;

  private:
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
