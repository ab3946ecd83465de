#ifndef rolling_contact_advice_unused_entries_h
#define rolling_contact_advice_unused_entries_h

#include <rolling_contact/input/prm_entries.h>

#include <string>
#include <vector>

namespace RollingContact
{
  struct SceneParameters;

  /**
   * What of the entries given, by Section/Entry and those that are not the
   * default, has no effect with the scene's analysis and dimension, a sentence
   * each.
   */
  std::vector<std::string>
  unused_entries(const SceneParameters &scene, const PrmEntries &given);
} // namespace RollingContact

#endif
