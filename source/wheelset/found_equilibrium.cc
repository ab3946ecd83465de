#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/wheelset/found_equilibrium.h>

namespace RollingContact
{
  std::optional<Eigen::Vector3d>
  FoundEquilibrium::bounds_of_balances(const double axle_load,
                                       const double half_base,
                                       const double radius) const
  {
    double force = 0.; // N, by which forces of friction may be off
    for (unsigned int wheel = 0; wheel < 2; ++wheel)
      {
        const auto of_wheel = error_bounds(*scenes[wheel], steady[wheel]).force;
        if (!of_wheel)
          return {};
        force += *of_wheel * state.wheels[wheel].friction_force;
      }
    return force / axle_load * Eigen::Vector3d(1., half_base, radius);
  }

  double FoundEquilibrium::energy_error(const double radius) const
  {
    const WheelsetState &at  = state;
    double               yaw = 0., axle = 0.;
    for (const WheelState &wheel : at.wheels)
      {
        yaw += wheel.forces.moment_z;
        axle += wheel.forces.axle_torque;
      }
    const double work = drag() - yaw * at.acting.curvature +
                        axle * (1 + at.place.excess) / radius,
                 carried =
                   at.wheels[0].friction_force + at.wheels[1].friction_force;
    return (creep_work() - work) / carried;
  }
} // namespace RollingContact
