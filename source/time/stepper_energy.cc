#include <rolling_contact/time/contact_stepper.h>

namespace RollingContact
{
  template <int dim>
  double ContactStepper<dim>::surface_work(const ContactState &previous,
                                           const double        time,
                                           const double        h) const
  {
    if (step_heights.empty())
      return 0.;
    // with inertia reactions are means over the step
    std::vector<double> pressure = contact.state.pressure;
    if (!scene.inputs->time.inertia)
      for (std::size_t i = 0; i < pressure.size(); ++i)
        pressure[i] = (pressure[i] + previous.pressure[i]) / 2;
    const std::vector<double> forces = contact.problem.operators.H().multiply(
                                pressure),
                              before = heights(time), now = heights(time + h);
    double work = 0.;
    for (std::size_t i = 0; i < forces.size(); ++i)
      work += forces[i] * (now[i] - before[i]);
    return work;
  }

  template <int dim>
  double ContactStepper<dim>::friction_heat(const double h,
                                            const double speed,
                                            const bool   smooth)
  {
    const SlipMemory before = std::move(slip);
    slip = slip_memory(contact.problem, contact.state, speed);
    if (motion->laws_in_the_middle())
      return h * slip.power;
    if (scene.inputs->time.inertia)
      return heat_within_step(
        before, theta(), h, contact.problem, contact.state, slip);
    return h * (smooth ? (before.power + slip.power) / 2 : slip.power);
  }

  template double ContactStepper<2>::surface_work(const ContactState &,
                                                  const double,
                                                  const double) const;
  template double ContactStepper<3>::surface_work(const ContactState &,
                                                  const double,
                                                  const double) const;
  template double
  ContactStepper<2>::friction_heat(const double, const double, const bool);
  template double
  ContactStepper<3>::friction_heat(const double, const double, const bool);
} // namespace RollingContact
