#ifndef rolling_contact_advice_idle_entries_h
#define rolling_contact_advice_idle_entries_h

#include <map>
#include <string>

namespace RollingContact
{
  struct SceneParameters;

  /**
   * Entries of sections Wheel and Rail that a scene has no use for, by
   * Section/Entry, and why, a clause each.
   */
  std::map<std::string, std::string>
  idle_body_entries(const SceneParameters &scene);

  /**
   * Entries on what a run in time passes over and leaves behind (surfaces,
   * spectra, sound, its end) that a scene has no use for, by Section/Entry, and
   * why, a clause each.
   */
  std::map<std::string, std::string>
  idle_entries_in_time(const SceneParameters &scene);

  /**
   * Why a run is too short for the spectra that are wanted of it, a sentence;
   * empty if it is not.
   */
  std::string
  missing_spectrum(const SceneParameters &scene);
} // namespace RollingContact

#endif
