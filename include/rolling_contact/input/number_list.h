#ifndef rolling_contact_input_number_list_h
#define rolling_contact_input_number_list_h

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * How a list of numbers is written, for the help of an entry.
   */
  extern const char *const number_list_form;

  /**
   * Numbers separated by commas, or "first : last : number of points", which
   * begins and ends with exactly these. Throws InputError, naming the @p entry
   * with its section, if it is neither.
   */
  std::vector<double> number_list(const std::string &entry,
                                  const std::string &text);

  /**
   * Numbers of a list, ascending, each once. Throws InputError if one is not
   * above 0, naming the unit.
   */
  std::vector<double> positive_numbers(const std::string &entry,
                                       const std::string &text,
                                       const std::string &unit);

  /**
   * Rolling speeds of positive_numbers(), in m/s; @p given alone if the entry
   * is empty.
   */
  std::vector<double> speeds_or(const double       given,
                                const std::string &entry,
                                const std::string &text);
} // namespace RollingContact

#endif
