#ifndef rolling_contact_scene_known_entries_h
#define rolling_contact_scene_known_entries_h

#include <rolling_contact/input/prm_entries.h>
#include <rolling_contact/scene/entry.h>

#include <set>
#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;
  struct SceneParameters;

  /**
   * The entries that do not belong to one analysis alone, to look up what holds
   * for them in any scene. Which analyses there are it does not know.
   */
  const Entries &known_entries();

  /**
   * What a new value of an entry renews; nothing but loads where the entry is
   * of a section that one analysis has for itself.
   */
  Renews renewed_by(const std::string &path);

  /**
   * What of the entries given, by Section/Entry and those that are not the
   * default, has no effect in a scene, a sentence each.
   */
  std::vector<std::string> unused_entries(const SceneParameters &scene,
                                          const PrmEntries      &given);

  /**
   * The entries that may differ when a run of this scene is resumed, see
   * RunFolder.
   */
  std::set<std::string> entries_free_on_resume(const SceneParameters &scene);
} // namespace RollingContact

#endif
