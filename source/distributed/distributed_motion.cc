#include <rolling_contact/base/text.h>
#include <rolling_contact/distributed/distributed_motion.h>
#include <rolling_contact/parallel/ranks.h>

#include <stdexcept>

namespace RollingContact
{
  using namespace dealii;

  template <int dim>
  DistributedMotion<dim>::DistributedMotion(
    const DistributedBody<dim>                  &body,
    std::shared_ptr<DistributedThetaSystem<dim>> system)
    : body(body)
    , system(system)
    , u(body.vector())
    , v(u)
    , Ku(u)
    , Mv(u)
    , f(u)
    , work(u)
    , z(u)
  {
    free_motion.now = free_motion.before = answer.now = answer.before = u;
  }



  template <int dim>
  std::unique_ptr<BodyDynamics>
  DistributedMotion<dim>::clone_state() const
  {
    return std::make_unique<DistributedMotion<dim>>(body, system);
  }



  template <int dim>
  void
  DistributedMotion<dim>::set_time_step(const double h)
  {
    start_anew();
    system->set_time_step(h);
  }



  template <int dim>
  void
  DistributedMotion<dim>::start_anew()
  {
    begun_step = 0.;
    free_motion.forget();
    answer.forget();
    answered.clear();
  }



  template <int dim>
  const DenseMatrix &
  DistributedMotion<dim>::contact_compliance() const
  {
    return system->contact_compliance();
  }



  template <int dim>
  void
  DistributedMotion<dim>::set_state(const DistributedVector &displacement,
                                    const DistributedVector &velocity)
  {
    u = displacement;
    v = velocity;
    system->multiply_stiffness(u, Ku);
    system->multiply_mass(v, Mv);
    step_energy         = StepEnergy();
    step_energy.kinetic = (v * Mv) / 2;
    step_energy.strain  = (u * Ku) / 2;
    start_anew();
  }



  template <int dim>
  void
  DistributedMotion<dim>::set_static_state(const BodyField &displacement)
  {
    DistributedVector field = body.vector();
    field.copy_locally_owned_data_from(displacement);
    for (const auto dof : field.locally_owned_elements())
      if (body.discretisation().constraints.is_constrained(dof))
        field(dof) = 0.;
    set_state(field, body.vector());
  }



  template <int dim>
  void
  DistributedMotion<dim>::set_flight_velocity(const double velocity)
  {
    DistributedVector flight = system->rise();
    flight *= velocity;
    set_state(body.vector(), flight);
  }



  template <int dim>
  void
  DistributedMotion<dim>::accelerate_hub(const double acceleration)
  {
    if (acceleration == last_acceleration)
      return;
    last_acceleration = acceleration;
    f.equ(-acceleration, translational_inertia());
  }



  template <int dim>
  const DistributedVector &
  DistributedMotion<dim>::translational_inertia()
  {
    if (inertia.size() == 0)
      {
        inertia = lumped_mass(body.discretisation());
        inertia.scale(system->rise());
      }
    return inertia;
  }



  template <int dim>
  double
  DistributedMotion<dim>::mean_velocity()
  {
    const DistributedVector &Me = translational_inertia();
    return (Me * v) / (Me * system->rise());
  }



  template <int dim>
  void
  DistributedMotion<dim>::begin_step()
  {
    begun_step         = system->time_step();
    const double scale = system->scheme().theta * begun_step;
    require_begun();
    work = Mv;
    work.add(-scale, Ku, scale, f);
    free_motion.extrapolate();
    n_iterations += system->solve(free_motion.now, work);
    ++n_solves;
    answer.extrapolate();
    answered.clear();
  }



  template <int dim>
  std::vector<double>
  DistributedMotion<dim>::response(const std::vector<double> &reactions)
  {
    require_begun();
    const double theta = system->scheme().theta;
    if (answered.empty() || reactions != answered)
      {
        work = 0.;
        body.add_forces(system->contact_dofs(), reactions, work);
        work *= theta * begun_step;
        n_iterations += system->solve(answer.now, work);
        ++n_solves;
        answered = reactions;
      }
    std::vector<double> result = on_contact(answer.now);
    for (double &value : result)
      value *= begun_step / theta;
    return result;
  }



  template <int dim>
  void
  DistributedMotion<dim>::end_step(const std::vector<double> &reactions)
  {
    require_begun();
    response(reactions);
    const double h             = begun_step;
    const double energy_before = step_energy.kinetic + step_energy.strain;
    work                       = free_motion.now;
    work += answer.now;
    begun_step = 0.;
    ++n_steps;

    step_energy              = StepEnergy();
    step_energy.contact_work = h * dot(reactions, on_contact(work));
    step_energy.load_work    = h * (f * work);
    move_displacement();
    change_velocity();
    step_energy.balance(energy_before);
  }



  template <int dim>
  void
  DistributedMotion<dim>::move_displacement()
  {
    const double h = system->time_step();
    u.add(h, work);
    system->multiply_stiffness(u, z);
    const double v_K_du = work * z - work * Ku;
    Ku.swap(z);
    step_energy.add_displacement(system->scheme(), h, u * Ku, v_K_du);
  }



  template <int dim>
  void
  DistributedMotion<dim>::change_velocity()
  {
    const double theta = system->scheme().theta;
    work.sadd(1 / theta, -1 / theta, v); // dv
    v += work;
    system->multiply_mass(v, z);
    const double dv_M_dv = work * z - work * Mv;
    // v_th = v - (1 - theta) dv, and the same of M v
    DistributedVector v_theta = v, Mv_theta = z;
    v_theta.add(-(1 - theta), work);
    Mv_theta.sadd(theta, 1 - theta, Mv);
    const double theta_v_M_v = v_theta * Mv_theta;
    Mv.swap(z);
    step_energy.add_velocity(
      system->scheme(), system->time_step(), v * Mv, dv_M_dv, theta_v_M_v);
  }



  template <int dim>
  std::vector<double>
  DistributedMotion<dim>::on_contact(const DistributedVector &values) const
  {
    return body.on_contact(system->contact_dofs(), values);
  }



  template <int dim>
  std::vector<double>
  DistributedMotion<dim>::free_contact_velocity() const
  {
    require_begun();
    return system->scheme().end_velocity(on_contact(free_motion.now),
                                         contact_velocity());
  }



  template <int dim>
  std::vector<double>
  DistributedMotion<dim>::free_contact_displacement() const
  {
    require_begun();
    return end_displacement(on_contact(free_motion.now),
                            contact_displacement(),
                            begun_step);
  }



  template <int dim>
  void
  DistributedMotion<dim>::require_begun() const
  {
    if (begun_step == 0. || begun_step != system->time_step())
      throw std::logic_error(
        "No time step has begun, or it was changed since.");
  }



  template <int dim>
  BodyField
  DistributedMotion<dim>::displacement() const
  {
    return body.field(u);
  }



  template <int dim>
  void
  DistributedMotion<dim>::remember()
  {
    kept = {u, v, Ku, Mv, step_energy};
  }



  template <int dim>
  void
  DistributedMotion<dim>::go_back()
  {
    // not collective: other ranks may not have failed
    u           = kept.u;
    v           = kept.v;
    Ku          = kept.Ku;
    Mv          = kept.Mv;
    step_energy = kept.energy;
    start_anew();
  }



  template <int dim>
  BodyDynamics::Memory
  DistributedMotion<dim>::memory_consumption() const
  {
    return system->memory_consumption();
  }



  template <int dim>
  std::string
  DistributedMotion<dim>::description() const
  {
    if (n_steps == 0)
      return "";
    return significant(double(n_solves) / n_steps, 3) + " solves and " +
           significant(double(n_iterations) / n_steps, 3) +
           " iterations in a step";
  }



  template class DistributedMotion<2>;
  template class DistributedMotion<3>;
} // namespace RollingContact
