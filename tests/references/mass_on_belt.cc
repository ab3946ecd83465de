#include "mass_on_belt.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/checks.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    void check(const MassOnBelt &belt)
    {
      check_positive("Mass", belt.mass, "kg");
      check_positive("Stiffness", belt.stiffness, "N/m");
      check_not_negative("Damping", belt.damping, "N s/m");
      check_positive("Load", belt.load, "N");
      check_positive("Speed of the belt", belt.belt_speed, "m/s");
      check_not_negative("Kinetic friction", belt.kinetic_friction);
      check_not_negative("Drop of friction",
                         belt.static_friction - belt.kinetic_friction);
    }
  } // namespace

  double MassOnBelt::growth(const double decay_speed) const
  {
    check(*this);
    check_positive("Decay speed", decay_speed, "m/s");
    const double slope = (static_friction - kinetic_friction) / decay_speed *
                         std::exp(-belt_speed / decay_speed);
    return (load * slope - damping) / (2 * mass);
  }

  double MassOnBelt::critical_speed(const double decay_speed) const
  {
    check(*this);
    check_positive("Decay speed", decay_speed, "m/s");
    check_positive("Damping", damping, "N s/m");
    const double ratio =
      load * (static_friction - kinetic_friction) / (damping * decay_speed);
    return ratio > 1. ? decay_speed * std::log(ratio) : 0.;
  }

  MassOnBelt::Cycle MassOnBelt::stick_slip_cycle() const
  {
    check(*this);
    const double frequency = std::sqrt(stiffness / mass),
                 drop      = (static_friction - kinetic_friction) * load;
    return {std::hypot(drop / stiffness, belt_speed / frequency),
            2 * drop / (stiffness * belt_speed),
            2 / frequency *
              (pi - std::atan(drop * frequency / (stiffness * belt_speed)))};
  }
} // namespace RollingContact::References
