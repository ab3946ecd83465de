#ifndef rolling_contact_scene_entry_h
#define rolling_contact_scene_entry_h

#include <deal.II/base/patterns.h>

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  struct SceneParameters;

  using SceneCondition = std::function<bool(const SceneParameters &)>;

  /**
   * The only part of this type that a scene has: the traits of its analysis, or
   * a section other than those of wheel and rail.
   */
  template <class Part>
  const Part &part_of(const SceneParameters &scene);

  /**
   * A condition on some parts of a scene.
   */
  template <class... Parts, class Condition>
  SceneCondition asks(const Condition &condition)
  {
    return [condition](const SceneParameters &scene) {
      return condition(part_of<Parts>(scene)...);
    };
  }

  /**
   * A condition on the section that one analysis alone reads. Where it is used
   * the type of a scene is complete.
   */
  template <class Section, class Condition>
  SceneCondition asks_own(const Condition &condition)
  {
    return [condition](const auto &scene) {
      return condition(scene.template own<Section>());
    };
  }

  /**
   * Who reads an entry: the scenes in which it has an effect, and a clause that
   * says why it has none in the others.
   */
  struct Reader
  {
    SceneCondition reads;
    std::string    otherwise;
  };

  /**
   * What a state needs anew when an entry has a new value, from what costs most
   * to what costs least.
   */
  enum class Renews
  {
    bodies, ///< the bodies, their mesh and the operators between them
    place,  ///< the place where bodies with profiles touch
    patch,  ///< the size of the patch
    loads   ///< nothing but the loads on bodies that are kept
  };

  /**
   * What the entries of a section have in common. The functions return the
   * section.
   */
  struct EntrySection
  {
    EntrySection &read_by(const Reader &reader)
    {
      readers.push_back(reader);
      return *this;
    }

    /**
     * The section is read by the analyses that say so, which @p names lists.
     */
    EntrySection &read_by_analyses(const std::string &names);

    /**
     * The section is read by the analyses that say so, and by transient runs
     * whose bodies are reduced to their modes; otherwise @p otherwise says why
     * it has no effect.
     */
    EntrySection &read_with_reduced_bodies(const std::string &otherwise);

    /**
     * Why no entry of the section has an effect in a scene, a clause; empty if
     * some have.
     */
    std::string why_idle(const SceneParameters &scene) const;

    std::string         name; ///< empty outside of sections
    std::vector<Reader> readers;
    SceneCondition      varies; ///< whether states of a table may differ by it
    SceneCondition free_on_resume; ///< of entries that are declared after this
    Renews         renews = Renews::bodies; ///< the same
  };

  /**
   * An entry of the .prm file: its name, the member it sets, its unit, what it
   * takes, what it means, when it has an effect and what a new value of it
   * needs. The functions that describe it return it.
   */
  class Entry
  {
  public:
    /** What values an entry takes. */
    enum class Kind
    {
      text,
      flag,
      integer,
      number,
      numbers ///< a form of numbers that `read` understands
    };

    Entry &at_least(const double bound);

    Entry &between(const double lower, const double upper);

    /**
     * The entry is one of @p names, "one|another".
     */
    Entry &one_of(const std::string &names);

    /**
     * The entry is a list separated by commas, of at least so many values.
     */
    Entry &several(const unsigned int least = 1);

    /**
     * The entry may be left empty, which is its default.
     */
    Entry &or_empty();

    /**
     * The entry may be this word, which is its default and which `read`
     * understands.
     */
    Entry &or_word(const std::string &word);

    Entry &read_by(const Reader &reader);

    Entry &read_by(const std::vector<Reader> &more);

    Entry &renewing(const Renews what);

    /**
     * A run that is resumed may have another value in scenes of this kind.
     */
    Entry &resumed_if(const SceneCondition &condition);

    /**
     * Section/Entry, or Entry outside of sections.
     */
    std::string path() const;

    /**
     * Why the entry has no effect in a scene that reads its section, a clause;
     * empty if it has one.
     */
    std::string why_idle(const SceneParameters &scene) const;

    /**
     * What the entry takes, in words with bounds and unit: "a number of at
     * least 0 Pa"; empty for any text.
     */
    std::string allowed() const;

    /**
     * Throws InputError, with the place in front, if the value is none that the
     * entry takes, naming what it takes.
     */
    void check(const std::string &value, const std::string &place) const;

    /**
     * Whether a value is the default; numbers are compared as numbers.
     */
    bool is_default(const std::string &value) const;

    /**
     * Whether the entry takes numbers and no names.
     */
    bool takes_numbers() const;

    /**
     * The help with the unit at its end.
     */
    std::string documentation() const;

    std::unique_ptr<dealii::Patterns::PatternBase> pattern() const;

    const EntrySection *section;
    std::string         name;
    std::string         unit; ///< "1" without dimension, empty if no number
    std::string         help;
    std::string         default_text;
    Kind                kind;
    /** Sets the member, or throws InputError and leaves it as it is. */
    std::function<void(const std::string &)> read;
    Renews                                   renews;
    SceneCondition                           free_on_resume;

  private:
    /** What the value is, unless it is the word. */
    std::unique_ptr<dealii::Patterns::PatternBase> value_pattern() const;

    double lower = std::numeric_limits<double>::lowest(),
           upper = std::numeric_limits<double>::max();
    std::optional<std::string>  word;  ///< that it may be, empty for nothing
    std::string                 names; ///< that it may be, "one|another"
    std::optional<unsigned int> least; ///< length of a list
    std::vector<Reader>         readers;
  };

  inline bool in_all_scenes(const SceneParameters &)
  {
    return true;
  }

  /**
   * Whether load, place and motion of the wheels are found, see
   * SceneParameters::finds_place().
   */
  bool place_is_found(const SceneParameters &scene);

  inline bool place_is_given(const SceneParameters &scene)
  {
    return !place_is_found(scene);
  }

  /**
   * An entry across the rolling direction.
   */
  Reader scenes_in_3d();

  /**
   * Runs that end with spectra, see SceneParameters::wants_spectra().
   */
  Reader scenes_with_spectra();

  /**
   * Analyses with a contact of meshed bodies.
   */
  Reader analyses_with_elements();

  Reader analyses_of_contact();
} // namespace RollingContact

#endif
