#include <rolling_contact/elasticity/direct_body.h>
#include <rolling_contact/elasticity/direct_motion.h>

namespace RollingContact
{
  template <int dim>
  DirectMotion<dim>::DirectMotion(const DirectBody<dim>       &body,
                                  std::shared_ptr<ThetaSystem> system)
    : body(body)
    , system(system)
    , stepper(system)
  {}



  template <int dim>
  std::unique_ptr<BodyDynamics>
  DirectMotion<dim>::clone_state() const
  {
    return std::make_unique<DirectMotion<dim>>(body, system);
  }



  template <int dim>
  void
  DirectMotion<dim>::set_time_step(const double h)
  {
    stepper.set_time_step(h);
  }



  template <int dim>
  const DenseMatrix &
  DirectMotion<dim>::contact_compliance() const
  {
    return system->contact_compliance();
  }



  template <int dim>
  std::vector<double>
  DirectMotion<dim>::response(const std::vector<double> &reactions)
  {
    std::vector<double> result(reactions.size(), 0.);
    contact_compliance().multiply_block(0, 0, reactions, result);
    return result;
  }



  template <int dim>
  void
  DirectMotion<dim>::set_static_state(const BodyField &displacement)
  {
    const std::vector<double> u = body.unknowns_of(displacement);
    stepper.set_state(u, std::vector<double>(u.size(), 0.));
  }



  template <int dim>
  void
  DirectMotion<dim>::set_flight_velocity(const double velocity)
  {
    const std::vector<double> v = body.uniform(dim - 1, velocity);
    stepper.set_state(std::vector<double>(v.size(), 0.), v);
  }



  template <int dim>
  void
  DirectMotion<dim>::accelerate_hub(const double acceleration)
  {
    if (acceleration == last_acceleration)
      return;
    last_acceleration         = acceleration;
    std::vector<double> loads = translational_inertia();
    for (double &load : loads)
      load *= -acceleration;
    stepper.set_loads(loads);
  }



  template <int dim>
  const std::vector<double> &
  DirectMotion<dim>::translational_inertia()
  {
    if (inertia.empty())
      {
        const std::vector<double> rise = body.uniform(dim - 1, 1.);
        inertia.resize(rise.size());
        body.mass(MassKind::lumped).multiply(rise, inertia);
      }
    return inertia;
  }



  template <int dim>
  double
  DirectMotion<dim>::mean_velocity()
  {
    const std::vector<double> &Me   = translational_inertia();
    const std::vector<double>  rise = body.uniform(dim - 1, 1.);
    return dot(Me, stepper.velocity()) / dot(Me, rise);
  }



  template <int dim>
  void
  DirectMotion<dim>::begin_step()
  {
    stepper.begin_step();
  }



  template <int dim>
  void
  DirectMotion<dim>::end_step(const std::vector<double> &reactions)
  {
    stepper.end_step(reactions);
  }



  template <int dim>
  void
  DirectMotion<dim>::begin_step_with(BodyDynamics &other)
  {
    ThetaStepper::begin_steps(stepper,
                              dynamic_cast<DirectMotion &>(other).stepper);
  }



  template <int dim>
  void
  DirectMotion<dim>::end_step_with(
    BodyDynamics              &other,
    const std::vector<double> &reactions,
    const std::vector<double> &reactions_of_other)
  {
    ThetaStepper::end_steps(stepper,
                            reactions,
                            dynamic_cast<DirectMotion &>(other).stepper,
                            reactions_of_other);
  }



  template <int dim>
  std::vector<double>
  DirectMotion<dim>::contact_displacement() const
  {
    return stepper.contact_displacement();
  }



  template <int dim>
  std::vector<double>
  DirectMotion<dim>::contact_velocity() const
  {
    return stepper.contact_velocity();
  }



  template <int dim>
  std::vector<double>
  DirectMotion<dim>::free_contact_displacement() const
  {
    return stepper.free_contact_displacement();
  }



  template <int dim>
  std::vector<double>
  DirectMotion<dim>::free_contact_velocity() const
  {
    return stepper.free_contact_velocity();
  }



  template <int dim>
  const StepEnergy &
  DirectMotion<dim>::energy() const
  {
    return stepper.energy();
  }



  template <int dim>
  BodyField
  DirectMotion<dim>::displacement() const
  {
    return body.field(stepper.displacement());
  }



  template <int dim>
  void
  DirectMotion<dim>::remember()
  {
    kept = {stepper.displacement(), stepper.velocity()};
  }



  template <int dim>
  void
  DirectMotion<dim>::go_back()
  {
    stepper.set_state(kept.displacement, kept.velocity);
  }



  template <int dim>
  const std::vector<std::size_t> &
  DirectMotion<dim>::order() const
  {
    if (portable_dof_order.empty())
      portable_dof_order = body.portable_dof_order();
    return portable_dof_order;
  }



  template <int dim>
  BodyMotion
  DirectMotion<dim>::save() const
  {
    BodyMotion motion;
    for (const std::size_t i : order())
      {
        motion.displacement.push_back(stepper.displacement()[i]);
        motion.velocity.push_back(stepper.velocity()[i]);
      }
    return motion;
  }



  template <int dim>
  void
  DirectMotion<dim>::restore(const BodyMotion &motion)
  {
    require_size(motion, body.n_unknowns());
    std::vector<double> u(body.n_unknowns()), v(body.n_unknowns());
    for (std::size_t k = 0; k < u.size(); ++k)
      {
        u[order()[k]] = motion.displacement[k];
        v[order()[k]] = motion.velocity[k];
      }
    stepper.set_state(u, v);
  }



  template <int dim>
  BodyDynamics::Memory
  DirectMotion<dim>::memory_consumption() const
  {
    return {system->stiffness().memory_consumption() +
              system->mass().memory_consumption(),
            system->factorisation().size().memory_consumption(),
            system->columns().memory_consumption()};
  }



  template class DirectMotion<2>;
  template class DirectMotion<3>;
} // namespace RollingContact
