#ifndef rolling_contact_input_prm_declared_h
#define rolling_contact_input_prm_declared_h

#include <rolling_contact/input/prm_text.h>

#include <map>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace RollingContact
{
  /**
   * All entries that a handler declares, to check what a user gives for them in
   * words of the user, before the handler takes it.
   */
  class DeclaredEntries
  {
  public:
    explicit DeclaredEntries(const dealii::ParameterHandler &prm);

    /**
     * Throws InputError, with the place in front, if there is no such entry,
     * naming those that may be meant, or if its pattern does not take the
     * value, naming what it takes and the unit.
     */
    void
    check(const PrmEntry &given) const;

    /**
     * The unit of a declared entry, empty for 1 and for what is no number.
     */
    const std::string &
    unit(const std::string &path) const;

    /**
     * What a declared entry takes, as deal.II describes it: "[Double 0...1".
     */
    const std::string &
    pattern(const std::string &path) const;

    /**
     * Throws InputError, with the place in front, if there is no such section.
     */
    void
    check_section(const PrmEntry &given) const;

    /**
     * The first half of check(): throws InputError, with the place in front, if
     * there is no such entry.
     */
    void
    check_exists(const PrmEntry &given) const;

    /**
     * Whether a declared entry is given what it is without that; numbers are
     * compared as numbers.
     */
    bool
    is_default(const PrmEntry &given) const;

  private:
    struct Entry
    {
      std::string pattern; ///< as deal.II describes it, "[Double 0...1 ...]"
      std::string unit;    ///< empty for 1 and for what is no number
      std::string default_value;
    };

    std::map<std::string, Entry> entries; ///< by Section/Entry
  };

  /**
   * What a pattern of deal.II takes, as a request: "give a number of at least 0
   * Pa". @p pattern: its description; @p unit: empty for none.
   */
  std::string
  what_is_allowed(const std::string &pattern, const std::string &unit);

  /**
   * All entries that a handler declares as JSON: an object for each section
   * that has an object for each entry, with the texts `default`, `meaning`,
   * `unit` (empty for 1 and for what is no number) and `allowed`, the values
   * that its pattern takes in words (empty where it takes any text). Entries
   * outside of sections stand beside the sections.
   */
  std::string
  entries_as_json(const dealii::ParameterHandler &prm);
} // namespace RollingContact

#endif
