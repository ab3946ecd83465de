#ifndef rolling_contact_vibration_mode_controls_h
#define rolling_contact_vibration_mode_controls_h

#include <rolling_contact/modes/structural_modes.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/scene/modes_parameters.h>

#include <string>

namespace RollingContact
{
  /**
   * What section Modes wants of the modes of a body up to @p cut_off (Hz). Once
   * they are counted, more than 1000 are told to @p log, which must outlive the
   * controls, and InputError is thrown, naming the entries of @p section, if
   * there are less than six unknowns for each: more modes than a mesh can tell
   * apart, whose search takes hours.
   */
  ModeControls mode_controls(const ModesParameters &wanted,
                             const double           cut_off,
                             const std::size_t      n_unknowns,
                             const std::string     &section,
                             Log                   &log);
} // namespace RollingContact

#endif
