#include <rolling_contact/distributed/distributed_theta_system.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** Relative residual of a solve in a time step. */
    const double step_tolerance = 5e-12;
  } // namespace



  template <int dim>
  DistributedThetaSystem<dim>::DistributedThetaSystem(
    const DistributedBody<dim>      &body,
    const ThetaScheme               &scheme,
    const MassKind                   mass,
    const std::vector<SurfaceNode>  &nodes,
    const std::vector<unsigned int> &components)
    : parameters(scheme)
    , contact(DistributedBody<dim>::contact_dofs(nodes, components))
    , modes(body.rigid_modes())
    , is_lumped(mass == MassKind::lumped)
  {
    parameters.check();
    assemble_stiffness(body.discretisation(), K);
    if (is_lumped)
      lumped = lumped_mass(body.discretisation());
    else
      assemble_mass(body.discretisation(), consistent);
    if (const auto direct = body.make_model())
      model = std::make_unique<ThetaSystem>(
        scheme,
        direct->stiffness(),
        direct->mass(mass),
        direct->nodes_of_unknowns(),
        direct->unknowns(body.model_nodes(*direct, nodes), components));
  }



  template <int dim>
  void
  DistributedThetaSystem<dim>::add_mass(const double factor)
  {
    if (is_lumped)
      {
        for (const auto dof : lumped.locally_owned_elements())
          A.add(dof, dof, factor * lumped(dof));
        A.compress(VectorOperation::add);
      }
    else
      A.add(factor, consistent);
  }



  template <int dim>
  void
  DistributedThetaSystem<dim>::set_time_step(const double new_h)
  {
    if (new_h == h)
      return;
    if (model)
      model->set_time_step(new_h);
    const double theta = parameters.theta;
    h                  = 0.; // should anything fail
    multigrid.reset();
    A.copy_from(K);
    A *= theta * new_h * (theta * new_h + parameters.stiffness_damping);
    add_mass(1 + theta * new_h * parameters.mass_damping);
    multigrid = std::make_unique<MultigridSolver>(A, modes, dim);
    h         = new_h;
  }



  template <int dim>
  const DenseMatrix &
  DistributedThetaSystem<dim>::contact_compliance() const
  {
    return model ? model->contact_compliance() : nothing;
  }



  template <int dim>
  void
  DistributedThetaSystem<dim>::multiply_stiffness(
    const DistributedVector &x,
    DistributedVector       &result) const
  {
    K.vmult(result, x);
  }



  template <int dim>
  void
  DistributedThetaSystem<dim>::multiply_mass(const DistributedVector &x,
                                             DistributedVector &result) const
  {
    if (!is_lumped)
      {
        consistent.vmult(result, x);
        return;
      }
    result = x;
    result.scale(lumped);
  }



  template <int dim>
  unsigned int
  DistributedThetaSystem<dim>::solve(DistributedVector       &x,
                                     const DistributedVector &b) const
  {
    std::vector<DistributedVector> solution{x};
    const auto report = multigrid->solve(solution, {b}, step_tolerance);
    x                 = solution[0];
    return report.iterations;
  }



  template <int dim>
  BodyDynamics::Memory
  DistributedThetaSystem<dim>::memory_consumption() const
  {
    BodyDynamics::Memory memory;
    memory.matrices = K.memory_consumption() + A.memory_consumption() +
                      consistent.memory_consumption() +
                      lumped.memory_consumption();
    memory.solver = multigrid ? multigrid->memory_consumption() : 0;
    if (model)
      memory.solver += model->memory_consumption();
    return memory;
  }



  template class DistributedThetaSystem<2>;
  template class DistributedThetaSystem<3>;
} // namespace RollingContact
