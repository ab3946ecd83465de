#ifndef rolling_contact_scene_scene_entries_h
#define rolling_contact_scene_scene_entries_h

#include <rolling_contact/scene/scene_parameters.h>

#include <map>
#include <memory>
#include <string>

namespace RollingContact
{
  /**
   * A scene whose entries are changed by name, as those of a .prm file, and
   * what of it a change needs anew. An object may be used by one thread at a
   * time; several do not know of each other.
   */
  class SceneEntries
  {
  public:
    explicit SceneEntries(const SceneParameters &scene);
    ~SceneEntries();

    SceneEntries(const SceneEntries &) = delete;
    SceneEntries &
    operator=(const SceneEntries &) = delete;

    /**
     * Throws InputError, with the @p place in front, unless the entry exists
     * and takes the value.
     */
    void
    check(const std::string &entry,
          const std::string &value,
          const std::string &place) const;

    /**
     * Throws InputError, with the @p place in front, unless a state may differ
     * from others by this entry, and by a number.
     */
    void
    check_variable(const std::string &entry, const std::string &place) const;

    /**
     * Give an entry another value, which check() would take.
     */
    void
    set(const std::string &entry, const std::string &value);

    /**
     * The unit of an entry; "1" where it has none.
     */
    std::string
    unit(const std::string &entry) const;

    /**
     * Throws InputError if the values of the entries contradict each other.
     */
    void
    check_scene() const;

    /**
     * What the bodies, their mesh and the operators between them depend on, of
     * what was set: the same text for scenes that may share them.
     */
    std::string
    bodies_key() const;

    /**
     * The scene as an analysis wants it, with the contact of profiles found
     * anew if bodies_key() has changed since this was last called. Throws
     * InputError.
     */
    SceneParameters
    scene();

  private:
    struct Handler;

    SceneParameters                    given;
    std::unique_ptr<Handler>           handler;
    std::map<std::string, std::string> of_bodies; ///< set entries
    std::string                        found_for; ///< the contact of profiles
  };

  /**
   * Whether an entry acts on bodies that are at hand: a number of section
   * Contact or Stability.
   */
  bool
  is_load(const std::string &entry);

  /**
   * Whether an entry says where bodies with profiles touch, and nothing of what
   * they are made of.
   */
  bool
  is_place(const std::string &entry);
} // namespace RollingContact

#endif
