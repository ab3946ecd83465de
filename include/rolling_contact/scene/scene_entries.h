#ifndef rolling_contact_scene_scene_entries_h
#define rolling_contact_scene_scene_entries_h

#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/situation.h>

#include <map>
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
    explicit SceneEntries(const Situation &first);

    SceneEntries(const SceneEntries &)            = delete;
    SceneEntries &operator=(const SceneEntries &) = delete;

    /**
     * Throws InputError, with the @p place in front, unless the entry exists
     * and takes the value.
     */
    void check(const std::string &entry,
               const std::string &value,
               const std::string &place) const;

    /**
     * Throws InputError, with the @p place in front, unless a state may differ
     * from others by this entry, and by a number; where places are found, by
     * one that has an effect.
     */
    void check_variable(const std::string &entry,
                        const std::string &place) const;

    /**
     * Give an entry another value, which check() would take. Throws InputError
     * and changes nothing if it is none all the same.
     */
    void set(const std::string &entry, const std::string &value);

    /**
     * The unit of an entry; "1" where it has none.
     */
    std::string unit(const std::string &entry) const;

    /**
     * Throws InputError if the values of the entries contradict each other.
     */
    void check_scene() const;

    /**
     * What the bodies, their mesh and the operators between them depend on, of
     * what was set: the same text for scenes that may share them. Where
     * profiles touch is a part of it if bodies follow them, and for linearised
     * vibrations.
     */
    std::string bodies_key() const;

    /**
     * Where profiles touch, of what was set: the same text for the same place.
     */
    std::string place_key() const
    {
      return text_of(of_place);
    }

    /**
     * The situation that follows from the entries. What does not depend on
     * those that changed since this was last called is shared, and no file of
     * it is read again. Throws InputError.
     */
    const Situation &situation();

  private:
    using SetEntries = std::map<std::string, std::string>;

    static std::string text_of(const SetEntries &entries);

    SceneParameters given;
    Entries         entries; ///< of `given`
    SetEntries      of_bodies, of_place;
    Situation       last;
    std::string     checked; ///< what of bodies was
  };
} // namespace RollingContact

#endif
