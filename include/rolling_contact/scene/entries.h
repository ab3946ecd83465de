#ifndef rolling_contact_scene_entries_h
#define rolling_contact_scene_entries_h

#include <rolling_contact/base/choices.h>
#include <rolling_contact/input/prm_text.h>
#include <rolling_contact/scene/entry.h>

#include <deque>
#include <map>
#include <type_traits>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * A name that an entry of the .prm file may have, and what it stands for.
   */
  template <class Kind>
  struct NamedValue
  {
    std::string name;
    Kind        kind;
  };

  /**
   * All entries of a scene. They set the members of the scene that declared
   * them, which must outlive them.
   */
  class Entries
  {
  public:
    Entries();
    Entries(const Entries &) = delete;
    Entries(Entries &&)      = default;

    /**
     * The entries that are added from now on stand in this section.
     */
    EntrySection &section(const std::string &name);

    /**
     * Add an entry for a member, whose value is the default.
     */
    template <class T>
    Entry &add(const std::string &name, T &value, const std::string &unit = "")
    {
      return parsed(name,
                    kind_of<T>(),
                    dealii::Patterns::Tools::to_string(value),
                    unit,
                    [&value](const std::string &text) {
                      dealii::Patterns::Tools::to_value(text, value);
                    });
    }

    /**
     * Add values separated by commas.
     */
    template <class T>
    Entry &add(const std::string &name,
               std::vector<T>    &values,
               const std::string &unit = "")
    {
      return parsed(name,
                    kind_of<T>(),
                    dealii::Patterns::Tools::to_string(values),
                    unit,
                    [&values](const std::string &text) {
                      dealii::Patterns::Tools::to_value(text, values);
                    })
        .several(0);
    }

    /**
     * Add a number that may be left empty, which is the default.
     */
    Entry &add(const std::string     &name,
               std::optional<double> &value,
               const std::string     &unit);

    /**
     * Add a number that may be `automatic`, which is the default and none.
     */
    Entry &add_automatic(const std::string     &name,
                         std::optional<double> &value,
                         const std::string     &unit);

    /**
     * A number_list(), which may be empty if the default is.
     */
    Entry &list(const std::string   &name,
                std::vector<double> &values,
                const std::string   &default_text,
                const std::string   &unit);

    /** What such a list looks like, for the help of entries. */
    static std::string form_of_lists();

    /**
     * A choice of one of @p choices by its `name`, which sets the `kind`.
     */
    template <class Choice, class Kind>
    Entry &choice(const std::string         &name,
                  Kind                      &value,
                  const std::vector<Choice> &choices)
    {
      std::string now;
      for (const Choice &it : choices)
        if (it.kind == value)
          now = it.name;
      return parsed(name,
                    Entry::Kind::text,
                    now,
                    "",
                    [&value, name, choices](const std::string &text) {
                      value = RollingContact::choice(choices, text, name).kind;
                    })
        .one_of(choice_names(choices));
    }

    /**
     * An entry that @p read understands, which throws InputError for values
     * that it does not.
     */
    Entry &parsed(const std::string                              &name,
                  const Entry::Kind                               kind,
                  const std::string                              &default_text,
                  const std::string                              &unit,
                  const std::function<void(const std::string &)> &read);

    /**
     * Declare all entries to deal.II's reader, which sets the members when it
     * reads.
     */
    void declare(dealii::ParameterHandler &prm) const;

    /**
     * Throws InputError, with the place in front, if there is no such entry,
     * naming those that may be meant.
     */
    const Entry &find(const std::string &path,
                      const std::string &place = "") const;

    /**
     * Throws InputError, with the place in front, if there is no such section.
     */
    void check_section(const PrmEntry &given) const;

    const std::deque<EntrySection> &sections() const
    {
      return all_sections;
    }

    const std::deque<Entry> &rows() const
    {
      return all;
    }

  private:
    template <class T>
    static constexpr Entry::Kind kind_of()
    {
      return std::is_same_v<T, bool>           ? Entry::Kind::flag
             : std::is_same_v<T, unsigned int> ? Entry::Kind::integer
             : std::is_same_v<T, double>       ? Entry::Kind::number
                                               : Entry::Kind::text;
    }

    std::deque<EntrySection>             all_sections;
    EntrySection                        *current = nullptr;
    std::deque<Entry>                    all;
    std::map<std::string, const Entry *> by_path;
  };

  /**
   * All entries as JSON: an object for each section that has an object for each
   * entry, with the texts `default`, `meaning`, `unit` (empty for 1 and for
   * what is not a number) and `allowed`, the values that it takes in words
   * (empty where it takes any text). Entries outside of sections stand beside
   * the sections.
   */
  std::string entries_as_json(const Entries &entries);
} // namespace RollingContact

#endif
