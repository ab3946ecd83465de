#ifndef rolling_contact_base_choices_h
#define rolling_contact_base_choices_h

#include <rolling_contact/base/exceptions.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The names of a table of choices as a selection, "one|another".
   */
  template <class Kind>
  std::string choice_names(const std::vector<Kind> &kinds)
  {
    std::string names;
    for (const Kind &kind : kinds)
      names += (names.empty() ? "" : "|") + kind.name;
    return names;
  }

  /**
   * The names and helps of a table of choices for the help of an entry, "`one`:
   * what it is; `another`: what that is."
   */
  template <class Kind>
  std::string choice_help(const std::vector<Kind> &kinds)
  {
    std::string help;
    for (const Kind &kind : kinds)
      help += (help.empty() ? "`" : "; `") + kind.name + "`: " + kind.help;
    return help + ".";
  }

  /**
   * The row of this @p name in a table of choices. Throws InputError, naming
   * the @p entry it was given in, if there is none.
   */
  template <class Kind>
  const Kind &choice(const std::vector<Kind> &kinds,
                     const std::string       &name,
                     const std::string       &entry)
  {
    for (const Kind &kind : kinds)
      if (kind.name == name)
        return kind;
    throw InputError(entry + " = " + name + ": choose one of " +
                     choice_names(kinds) + ".");
  }
} // namespace RollingContact

#endif
