#include <rolling_contact/damage/damage_parameters.h>
#include <rolling_contact/references/checks.h>

namespace RollingContact::Damage
{
  void DamageParameters::check() const
  {
    References::check_positive("Hardness", hardness, "Pa");
    References::check_positive("Density", density, "kg/m^3");
    References::check_positive("Shear yield stress", shear_yield_stress, "Pa");
    References::check_not_negative("Worn mass per energy",
                                   worn_mass_per_energy,
                                   "kg/J");
  }
} // namespace RollingContact::Damage
