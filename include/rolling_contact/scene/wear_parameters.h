#ifndef rolling_contact_scene_wear_parameters_h
#define rolling_contact_scene_wear_parameters_h

#include <rolling_contact/damage/damage_parameters.h>
#include <rolling_contact/damage/rcf_indices.h>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Wear`: whether wear and rolling contact fatigue of steady states
   * are told, and the constants of their laws.
   */
  struct WearParameters : Damage::DamageParameters
  {
    void declare(Entries &entries);

    /** Throws InputError if a constant is not above 0. */
    void check() const;

    bool                    report    = false;
    Damage::DamageThreshold threshold = Damage::DamageThreshold::newton_15;
  };
} // namespace RollingContact

#endif
