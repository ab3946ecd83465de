#ifndef rolling_contact_input_prm_declarations_h
#define rolling_contact_input_prm_declarations_h

#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/choices.h>

#include <optional>
#include <string>
#include <vector>

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
   * Declare an entry that chooses the @p kind of one of @p choices by its
   * @p name. Reading sets @p value, which must outlive the handler's reading;
   * its present value is the default.
   */
  template <class Choice, class Kind>
  void
  declare_choice(dealii::ParameterHandler  &prm,
                 const std::string         &entry,
                 Kind                      &value,
                 const std::vector<Choice> &choices,
                 const std::string         &help)
  {
    std::string name;
    for (const Choice &it : choices)
      if (it.kind == value)
        name = it.name;
    prm.declare_entry(entry,
                      name,
                      dealii::Patterns::Selection(choice_names(choices)),
                      help);
    prm.add_action(entry, [&value, entry, choices](const std::string &text) {
      value = choice(choices, text, entry).kind;
    });
  }

  /**
   * Declare Section/Entry, in its section, for a number that may be left empty,
   * which is the default. Reading throws InputError, naming the @p unit, if it
   * is neither.
   */
  void
  declare_number(dealii::ParameterHandler &prm,
                 const std::string        &path,
                 std::optional<double>    &value,
                 const std::string        &unit,
                 const std::string        &help);

  /**
   * Declare Section/Entry, in its section, for a number_list(), which may be
   * empty if the default is.
   */
  void
  declare_number_list(dealii::ParameterHandler &prm,
                      const std::string        &path,
                      std::vector<double>      &values,
                      const std::string        &default_text,
                      const std::string        &help);

  /**
   * A finite number and nothing else; none if the text is something else.
   */
  std::optional<double>
  number(const std::string &text);

  /**
   * A number as messages quote that of an entry.
   */
  std::string
  text_of(const double value);
} // namespace RollingContact

#endif
