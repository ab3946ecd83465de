#include <rolling_contact/contact/friction_memory.h>
#include <rolling_contact/time/contact_stepper.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  template <int dim>
  void ContactStepper<dim>::set_drive(const double time, const double h)
  {
    ContactProblem &problem = contact.problem;
    const double    end     = time + h;
    const double    laws    = time_of_laws(time, h);
    problem.loads.forces    = histories.forces(time + theta() * h);
    problem.loads.creepages = start_of_search(problem.loads.forces,
                                              problem.loads.creepages,
                                              histories.creepages(laws));
    set_friction(time, h);
    // reactions act at t + theta h, the shifted law holds beyond the end
    const bool   ahead = scene.inputs->time.contact_law == ContactLaw::shifted;
    const double holds = motion->laws_in_the_middle()
                           ? laws
                           : end + (ahead ? (1 - theta()) * h : 0.);
    step_heights       = heights(holds);
    if (histories.normal_load)
      problem.loads.normal_load =
        histories.normal_load->value(time + theta() * h);
    else
      problem.loads.approach = histories.approach->value(holds);
  }

  template <int dim>
  void ContactStepper<dim>::set_friction(const double time, const double h)
  {
    ContactLoads &loads = contact.problem.loads;
    if (!scene.surfaces.friction_share.empty())
      loads.friction =
        contact.pair->friction_at_nodes(scene.contact,
                                        travelled.value(time + h));
    if (!loads.friction_law || loads.memory_length <= 0.)
      return;
    loads.step_path =
      std::abs(histories.speed.value(time) + histories.speed.value(time + h)) /
      2 * h;
    loads.friction_arriving =
      moved_with_flow(contact.problem.operators,
                      contact.state.friction.empty() ? loads.friction
                                                     : contact.state.friction,
                      loads.friction,
                      loads.step_path);
  }

  template <int dim>
  std::vector<double> ContactStepper<dim>::heights(const double time) const
  {
    const MovingSurfaces &surfaces = contact.pair->moving_surfaces();
    if (!surfaces.in_use())
      return {};
    return surfaces.heights(contact.problem.operators.positions(),
                            travelled.value(time));
  }

  template <int dim>
  bool ContactStepper<dim>::follows_jump(const double time,
                                         const double h) const
  {
    if (!histories.forces(time).any())
      return false;
    const bool starts =
      time < 1.5 * h && scene.inputs->time.initial_state == InitialState::rest;
    return starts || histories.jump_between(std::max(0., time - h), time);
  }

  template <int dim>
  std::array<double, 3> ContactStepper<dim>::contact_velocity() const
  {
    std::array<double, 3>     mean{};
    const std::vector<double> velocity = motion->contact_velocity();
    if (velocity.empty())
      return mean;
    const ContactOperators &operators = contact.problem.operators;
    const std::size_t       n         = operators.n_nodes();
    const bool touches = operators.resultant(contact.state.pressure) > 0.;
    double     sum     = 0.;
    for (std::size_t i = 0; i < n; ++i)
      {
        const double weight =
          operators.areas()[i] * (touches ? contact.state.pressure[i] : 1.);
        sum += weight;
        for (unsigned int c = 0; c < operators.n_tangential(); ++c)
          mean[c] += weight * velocity[c * n + i];
        mean[2] += weight * velocity[velocity.size() - n + i];
      }
    for (double &value : mean)
      value /= sum;
    return mean;
  }

  template <int dim>
  Disturbance ContactStepper<dim>::disturbance() const
  {
    Disturbance found{*motion->reduced_state(), {0., 0.}};
    found.motion.add(-1., undisturbed.motion);
    if (patch_friction)
      {
        const PatchMemory &now = patch_friction->memory(),
                          &was = undisturbed.friction;
        found.friction = {now.share - was.share, now.target - was.target};
      }
    return found;
  }

  template void ContactStepper<2>::set_drive(const double, const double);
  template std::vector<double>   ContactStepper<2>::heights(const double) const;
  template std::array<double, 3> ContactStepper<2>::contact_velocity() const;
  template Disturbance           ContactStepper<2>::disturbance() const;
  template bool                  ContactStepper<2>::follows_jump(const double,
                                                const double) const;
  template void ContactStepper<3>::set_drive(const double, const double);
  template std::vector<double>   ContactStepper<3>::heights(const double) const;
  template std::array<double, 3> ContactStepper<3>::contact_velocity() const;
  template Disturbance           ContactStepper<3>::disturbance() const;
  template bool                  ContactStepper<3>::follows_jump(const double,
                                                const double) const;
} // namespace RollingContact
