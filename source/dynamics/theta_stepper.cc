#include <rolling_contact/dynamics/theta_stepper.h>

#include <stdexcept>
#include <utility>

namespace RollingContact
{
  ThetaStepper::ThetaStepper(std::shared_ptr<ThetaSystem> system)
    : matrices(std::move(system))
    , u(matrices->mass().size(), 0.)
    , v(u)
    , Ku(u)
    , Mv(u)
    , z(u)
    , work(u)
  {}



  void
  ThetaStepper::set_time_step(const double h)
  {
    abandon_step();
    matrices->set_time_step(h);
  }



  void
  ThetaStepper::set_state(const std::vector<double> &displacement,
                          const std::vector<double> &velocity)
  {
    if (displacement.size() != u.size() || velocity.size() != v.size())
      throw std::logic_error("A state of another body.");
    abandon_step();
    u = displacement;
    v = velocity;
    matrices->stiffness().multiply(u, Ku);
    matrices->mass().multiply(v, Mv);
    step_energy         = StepEnergy();
    step_energy.kinetic = dot(v, Mv) / 2;
    step_energy.strain  = dot(u, Ku) / 2;
  }



  void
  ThetaStepper::set_loads(const std::vector<double> &loads)
  {
    if (!loads.empty() && loads.size() != u.size())
      throw std::logic_error("Loads of another body.");
    abandon_step();
    f = loads;
  }



  void
  ThetaStepper::begin_momentum()
  {
    begun_step         = matrices->time_step();
    const double scale = matrices->scheme().theta * begun_step;
    require_begun();
    for (std::size_t i = 0; i < work.size(); ++i)
      work[i] = Mv[i] - scale * Ku[i];
    for (std::size_t i = 0; i < f.size(); ++i)
      work[i] += scale * f[i];
  }



  void
  ThetaStepper::begin_step()
  {
    begin_momentum();
    matrices->factorisation().solve_forward(work, z);
    free_theta_velocity = matrices->columns().transposed_product(z);
  }



  void
  ThetaStepper::begin_steps(ThetaStepper &first, ThetaStepper &second)
  {
    first.require_same_matrices(second);
    first.begin_momentum();
    second.begin_momentum();
    const ThetaSystem &system = *first.matrices;
    system.factorisation().solve_forward({&first.work, &second.work},
                                         {&first.z, &second.z});
    for (ThetaStepper *stepper : {&first, &second})
      stepper->free_theta_velocity =
        system.columns().transposed_product(stepper->z);
  }



  void
  ThetaStepper::end_step(const std::vector<double> &reactions)
  {
    require_begun();
    matrices->columns().add_product(matrices->scheme().theta * begun_step,
                                    reactions,
                                    z);
    matrices->factorisation().solve_backward(z, work);
    const double energy_before = move_displacement(reactions);
    matrices->stiffness().multiply(u, z);
    change_velocity();
    matrices->mass().multiply(v, z);
    finish_step(energy_before);
  }



  void
  ThetaStepper::end_steps(ThetaStepper              &first,
                          const std::vector<double> &first_reactions,
                          ThetaStepper              &second,
                          const std::vector<double> &second_reactions)
  {
    first.require_same_matrices(second);
    first.require_begun();
    second.require_begun();
    const ThetaSystem &system = *first.matrices;
    const double       scale  = system.scheme().theta * first.begun_step;
    system.columns().add_product(scale, first_reactions, first.z);
    system.columns().add_product(scale, second_reactions, second.z);
    system.factorisation().solve_backward({&first.z, &second.z},
                                          {&first.work, &second.work});
    const double energy_of_first  = first.move_displacement(first_reactions),
                 energy_of_second = second.move_displacement(second_reactions);
    system.stiffness().multiply(first.u, first.z, second.u, second.z);
    first.change_velocity();
    second.change_velocity();
    system.mass().multiply(first.v, first.z, second.v, second.z);
    first.finish_step(energy_of_first);
    second.finish_step(energy_of_second);
  }



  double
  ThetaStepper::move_displacement(const std::vector<double> &reactions)
  {
    const double h             = begun_step;
    const double energy_before = step_energy.kinetic + step_energy.strain;
    abandon_step();
    step_energy              = StepEnergy();
    step_energy.contact_work = h * dot(reactions, on_contact(work));
    step_energy.load_work    = f.empty() ? 0. : h * dot(f, work);
    if (matrices->damping().size() > 0)
      {
        matrices->damping().multiply(work, z);
        step_energy.damping = h * dot(work, z);
      }
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += h * work[i];
    return energy_before;
  }



  void
  ThetaStepper::change_velocity()
  {
    const double theta  = matrices->scheme().theta;
    double       v_K_du = 0., u_K_u = 0.;
    for (std::size_t i = 0; i < u.size(); ++i)
      {
        v_K_du += work[i] * (z[i] - Ku[i]);
        u_K_u += u[i] * z[i];
        work[i] = (work[i] - v[i]) / theta;
        v[i] += work[i];
      }
    std::swap(z, Ku);
    step_energy.add_displacement(matrices->scheme(),
                                 matrices->time_step(),
                                 u_K_u,
                                 v_K_du);
  }



  void
  ThetaStepper::finish_step(const double energy_before)
  {
    const double theta   = matrices->scheme().theta;
    double       dv_M_dv = 0., theta_v_M_v = 0., v_M_v = 0.;
    for (std::size_t i = 0; i < v.size(); ++i)
      {
        dv_M_dv += work[i] * (z[i] - Mv[i]);
        theta_v_M_v +=
          (v[i] - (1 - theta) * work[i]) * (theta * z[i] + (1 - theta) * Mv[i]);
        v_M_v += v[i] * z[i];
      }
    std::swap(z, Mv);
    step_energy.add_velocity(
      matrices->scheme(), matrices->time_step(), v_M_v, dv_M_dv, theta_v_M_v);
    step_energy.balance(energy_before);
  }



  std::vector<double>
  ThetaStepper::contact_displacement() const
  {
    return on_contact(u);
  }



  std::vector<double>
  ThetaStepper::contact_velocity() const
  {
    return on_contact(v);
  }



  const std::vector<double> &
  ThetaStepper::free_contact_theta_velocity() const
  {
    require_begun();
    return free_theta_velocity;
  }



  std::vector<double>
  ThetaStepper::free_contact_velocity() const
  {
    require_begun();
    return matrices->scheme().end_velocity(free_theta_velocity,
                                           contact_velocity());
  }



  std::vector<double>
  ThetaStepper::free_contact_displacement() const
  {
    require_begun();
    return end_displacement(free_theta_velocity,
                            contact_displacement(),
                            begun_step);
  }



  void
  ThetaStepper::require_begun() const
  {
    if (begun_step == 0. || begun_step != matrices->time_step())
      throw std::logic_error(
        "No time step has begun, or it was changed since.");
  }



  void
  ThetaStepper::require_same_matrices(const ThetaStepper &other) const
  {
    if (matrices != other.matrices || this == &other)
      throw std::logic_error("Not two states of the same body.");
  }



  std::vector<double>
  ThetaStepper::on_contact(const std::vector<double> &values) const
  {
    std::vector<double> result;
    result.reserve(matrices->contact_unknowns().size());
    for (const std::size_t i : matrices->contact_unknowns())
      result.push_back(values[i]);
    return result;
  }
} // namespace RollingContact
