#ifndef rolling_contact_analyses_stability_drivers_h
#define rolling_contact_analyses_stability_drivers_h

#include <rolling_contact/scene/contact_parameters.h>
#include <rolling_contact/stability/threshold.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A quantity that is changed to now + change * unit, and what of the contact
   * it is; the damping of all modes if it is nothing of it. Units: 1.
   */
  struct StateDriver
  {
    std::string quantity;
    double      now   = 0.;
    double      unit  = 0.;
    double      whole = 0.; ///< of which changes are a share; 0: of nothing
    void (*set)(ContactParameters &contact, const double value) = nullptr;
    ThresholdSearch search                                      = {};

    double value(const double change) const
    {
      return change == 0. ? now : now + change * unit;
    }
  };

  /**
   * What is changed of a state that squeals: less friction, less of each
   * creepage, and where it slides across, the direction of the creepage. Where
   * forces are asked for, creepages follow: friction alone.
   */
  std::vector<StateDriver> possible_cures(const ContactParameters &contact);

  /**
   * What is changed of a state that is stable: more friction and creepage, up
   * to twice of each and to a coefficient of 0.9, beyond which waves of the
   * patch itself grow.
   */
  std::vector<StateDriver> possible_onsets(const ContactParameters &contact);

  /**
   * Damping of all modes beyond what they have @p now, in steps of the largest
   * ratio that vibrations are @p lacking.
   */
  StateDriver more_damping(const double now, const double lacking);
} // namespace RollingContact

#endif
