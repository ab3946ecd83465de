#include <rolling_contact/bodies/distributed_theta_system.h>
#include <rolling_contact/bodies/theta_stepper.h>

#include <stdexcept>
#include <utility>

namespace RollingContact
{
  namespace
  {
    /** Number of values of a vector on this rank. */
    template <typename Vector>
    std::size_t n_here(const Vector &x)
    {
      return x.end() - x.begin();
    }
  } // namespace

  template <typename System>
  ThetaStepper<System>::ThetaStepper(std::shared_ptr<System> system)
    : system(system)
    , now(system->vector())
    , work(now.u)
  {}

  template <typename System>
  void ThetaStepper<System>::start_anew()
  {
    begun_step = 0.;
    work.forget();
  }

  template <typename System>
  void ThetaStepper<System>::set_time_step(const double h)
  {
    start_anew();
    system->set_time_step(h);
  }

  template <typename System>
  void ThetaStepper<System>::set_state(const Vector &displacement,
                                       const Vector &velocity)
  {
    if (displacement.size() != now.u.size() || velocity.size() != now.v.size())
      throw std::logic_error("A state of another body.");
    start_anew();
    now.u = displacement;
    now.v = velocity;
    system->multiply_stiffness({{&now.u, &now.Ku}});
    system->multiply_mass({{&now.v, &now.Mv}});
    now.energy         = StepEnergy();
    now.energy.kinetic = System::dot(now.v, now.Mv) / 2;
    now.energy.strain  = System::dot(now.u, now.Ku) / 2;
  }

  template <typename System>
  void ThetaStepper<System>::set_loads(const Vector &loads)
  {
    if (loads.size() != 0 && loads.size() != now.u.size())
      throw std::logic_error("Loads of another body.");
    begun_step = 0.;
    f          = loads;
  }

  template <typename System>
  void ThetaStepper<System>::go_back()
  {
    // not collective: other ranks may not have failed
    start_anew();
    now = kept;
  }

  template <typename System>
  void ThetaStepper<System>::begin_momentum()
  {
    begun_step = system->time_step();
    require_begun();
    const double scale = system->scheme().theta * begun_step;
    for (std::size_t i = 0; i < n_here(now.u); ++i)
      work.momentum.begin()[i] = now.Mv.begin()[i] - scale * now.Ku.begin()[i];
    for (std::size_t i = 0; i < n_here(f); ++i)
      work.momentum.begin()[i] += scale * f.begin()[i];
  }

  template <typename System>
  void
  ThetaStepper<System>::begin_steps(const std::vector<ThetaStepper *> &states)
  {
    std::vector<typename System::Work *> works;
    for (ThetaStepper *state : states)
      {
        state->begin_momentum();
        works.push_back(&state->work);
      }
    states[0]->system->begin(works);
  }

  template <typename System>
  void ThetaStepper<System>::end_steps(
    const std::vector<ThetaStepper *>              &states,
    const std::vector<const std::vector<double> *> &reactions)
  {
    std::vector<typename System::Work *> works;
    typename System::Products            of_stiffness, of_mass;
    for (ThetaStepper *state : states)
      {
        state->require_begun();
        works.push_back(&state->work);
        of_stiffness.push_back({&state->now.u, &state->work.z});
        of_mass.push_back({&state->now.v, &state->work.z});
      }
    const System &system = *states[0]->system;
    system.end(works, reactions);
    std::vector<double> energy_before;
    for (std::size_t k = 0; k < states.size(); ++k)
      energy_before.push_back(states[k]->move_displacement(*reactions[k]));
    system.multiply_stiffness(of_stiffness);
    for (ThetaStepper *state : states)
      state->change_velocity();
    system.multiply_mass(of_mass);
    for (std::size_t k = 0; k < states.size(); ++k)
      states[k]->finish_step(energy_before[k]);
  }

  template <typename System>
  std::vector<double>
  ThetaStepper<System>::response(const std::vector<double> &reactions)
  {
    require_begun();
    return system->response(work, reactions);
  }

  template <typename System>
  double
  ThetaStepper<System>::move_displacement(const std::vector<double> &reactions)
  {
    const double  h             = begun_step;
    StepEnergy   &energy        = now.energy;
    const double  energy_before = energy.kinetic + energy.strain;
    const Vector &v_th          = work.momentum;
    begun_step                  = 0.;
    energy                      = StepEnergy();
    energy.contact_work         = h * dot(reactions, system->on_contact(v_th));
    energy.load_work            = f.size() == 0 ? 0. : h * System::dot(f, v_th);
    if (system->multiply_damping(v_th, work.z))
      energy.damping = h * System::dot(v_th, work.z);
    for (std::size_t i = 0; i < n_here(now.u); ++i)
      now.u.begin()[i] += h * v_th.begin()[i];
    return energy_before;
  }

  template <typename System>
  void ThetaStepper<System>::change_velocity()
  {
    const auto dv = work.momentum.begin(), u = now.u.begin(), v = now.v.begin(),
               z = work.z.begin(), Ku = now.Ku.begin();
    const double theta = system->scheme().theta;
    double       u_K_u = 0., v_K_du = 0.;
    for (std::size_t i = 0; i < n_here(now.u); ++i)
      {
        u_K_u += u[i] * z[i];
        v_K_du += dv[i] * (z[i] - Ku[i]);
        dv[i] = (dv[i] - v[i]) / theta;
        v[i] += dv[i];
      }
    work.z.swap(now.Ku);
    std::vector<double> sums{u_K_u, v_K_du};
    System::sum(sums);
    const ThetaScheme &scheme = system->scheme();
    now.energy.strain         = sums[0] / 2;
    now.energy.damping += scheme.stiffness_damping * sums[1];
    now.energy.numerical_dissipation +=
      (theta - 0.5) * system->time_step() * sums[1];
  }

  template <typename System>
  void ThetaStepper<System>::finish_step(const double energy_before)
  {
    const auto dv = work.momentum.begin(), v = now.v.begin(),
               z = work.z.begin(), Mv = now.Mv.begin();
    const double theta = system->scheme().theta;
    double       v_M_v = 0., dv_M_dv = 0., theta_v_M_v = 0.;
    for (std::size_t i = 0; i < n_here(now.v); ++i)
      {
        v_M_v += v[i] * z[i];
        dv_M_dv += dv[i] * (z[i] - Mv[i]);
        theta_v_M_v +=
          (v[i] - (1 - theta) * dv[i]) * (theta * z[i] + (1 - theta) * Mv[i]);
      }
    work.z.swap(now.Mv);
    std::vector<double> sums{v_M_v, dv_M_dv, theta_v_M_v};
    System::sum(sums);
    now.energy.kinetic = sums[0] / 2;
    now.energy.numerical_dissipation += (theta - 0.5) * sums[1];
    now.energy.damping +=
      system->time_step() * system->scheme().mass_damping * sums[2];
    now.energy.balance(energy_before);
  }

  template <typename System>
  const std::vector<double> &
  ThetaStepper<System>::free_contact_theta_velocity() const
  {
    require_begun();
    return work.free_velocity;
  }

  template <typename System>
  std::vector<double> ThetaStepper<System>::free_contact_velocity() const
  {
    const std::vector<double> &free  = free_contact_theta_velocity();
    const double               theta = system->scheme().theta;
    std::vector<double>        v     = contact_velocity();
    for (std::size_t i = 0; i < v.size(); ++i)
      v[i] = (free[i] - (1 - theta) * v[i]) / theta;
    return v;
  }

  template <typename System>
  std::vector<double> ThetaStepper<System>::free_contact_displacement() const
  {
    const std::vector<double> &free = free_contact_theta_velocity();
    std::vector<double>        u    = contact_displacement();
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += begun_step * free[i];
    return u;
  }

  template <typename System>
  void ThetaStepper<System>::require_begun() const
  {
    if (begun_step == 0. || begun_step != system->time_step())
      throw std::logic_error(
        "No time step has begun, or it was changed since.");
  }

  template <typename System>
  void ThetaStepper<System>::step_with(ThetaStepper &other)
  {
    if (other.system != system || &other == this)
      throw std::logic_error("Not two states of the same body.");
    twin = &other;
  }

  template <typename System>
  ThetaStepper<System> &ThetaStepper<System>::the_twin() const
  {
    if (!twin)
      throw std::logic_error("This state of a body has no twin.");
    return *twin;
  }

  template class ThetaStepper<ThetaSystem>;
  template class ThetaStepper<DistributedThetaSystem<2>>;
  template class ThetaStepper<DistributedThetaSystem<3>>;
} // namespace RollingContact
