#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/bodies/distributed_theta_system.h>

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
    : body(body)
    , parameters(scheme)
    , contact(DistributedBody<dim>::contact_dofs(nodes, components))
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
  void DistributedThetaSystem<dim>::add_mass(const double factor)
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
  void DistributedThetaSystem<dim>::set_time_step(const double new_h)
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
    multigrid = std::make_unique<MultigridSolver>(A, body.rigid_modes(), dim);
    h         = new_h;
  }

  template <int dim>
  const DenseMatrix &DistributedThetaSystem<dim>::contact_compliance() const
  {
    return model ? model->contact_compliance() : nothing;
  }

  template <int dim>
  DistributedThetaSystem<dim>::Work::Work(const Vector &zero)
    : momentum(zero)
    , z(zero)
  {
    free_motion.now = free_motion.before = answer.now = answer.before = zero;
  }

  template <int dim>
  void DistributedThetaSystem<dim>::Work::forget()
  {
    free_motion.forget();
    answer.forget();
    answered.clear();
  }

  template <int dim>
  std::string DistributedThetaSystem<dim>::Work::description() const
  {
    if (n_steps == 0)
      return "";
    return significant(double(n_solves) / n_steps, 3) + " solves and " +
           significant(double(n_iterations) / n_steps, 3) +
           " iterations in a step";
  }

  template <int dim>
  void DistributedThetaSystem<dim>::solve(Vector &x, Work &state) const
  {
    std::vector<Vector> solution{x};
    state.n_iterations +=
      multigrid->solve(solution, {state.momentum}, step_tolerance).iterations;
    ++state.n_solves;
    x = solution[0];
  }

  template <int dim>
  void
  DistributedThetaSystem<dim>::begin(const std::vector<Work *> &states) const
  {
    for (Work *state : states)
      {
        state->free_motion.extrapolate();
        solve(state->free_motion.now, *state);
        state->free_velocity = on_contact(state->free_motion.now);
        state->answer.extrapolate();
        state->answered.clear();
      }
  }

  template <int dim>
  std::vector<double> DistributedThetaSystem<dim>::response(
    Work                      &state,
    const std::vector<double> &reactions) const
  {
    if (state.answered.empty() || reactions != state.answered)
      {
        state.momentum = 0.;
        body.add_forces(contact, reactions, state.momentum);
        state.momentum *= parameters.theta * h;
        solve(state.answer.now, state);
        state.answered = reactions;
      }
    std::vector<double> result = on_contact(state.answer.now);
    for (double &value : result)
      value *= h / parameters.theta;
    return result;
  }

  template <int dim>
  void DistributedThetaSystem<dim>::end(
    const std::vector<Work *>                      &states,
    const std::vector<const std::vector<double> *> &reactions) const
  {
    for (std::size_t k = 0; k < states.size(); ++k)
      {
        Work &state = *states[k];
        response(state, *reactions[k]);
        state.momentum = state.free_motion.now;
        state.momentum += state.answer.now;
        ++state.n_steps;
      }
  }

  template <int dim>
  void DistributedThetaSystem<dim>::multiply_stiffness(
    const Products &products) const
  {
    for (const auto &[x, result] : products)
      K.vmult(*result, *x);
  }

  template <int dim>
  void
  DistributedThetaSystem<dim>::multiply_mass(const Products &products) const
  {
    for (const auto &[x, result] : products)
      if (is_lumped)
        {
          *result = *x;
          result->scale(lumped);
        }
      else
        consistent.vmult(*result, *x);
  }

  template <int dim>
  void DistributedThetaSystem<dim>::sum(std::vector<double> &values)
  {
    Ranks::sum(values);
  }

  template <int dim>
  BodyDynamics::Memory DistributedThetaSystem<dim>::memory() const
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
