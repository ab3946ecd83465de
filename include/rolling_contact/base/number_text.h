#ifndef rolling_contact_base_number_text_h
#define rolling_contact_base_number_text_h

#include <optional>
#include <string>

namespace RollingContact
{
  /**
   * The number that all of a text is, blanks in front of it aside; nothing if
   * it is empty or anything stands behind the number, be it a byte of zero.
   * `inf`, `nan` and what is too large are numbers that are not finite, what is
   * too small is the nearest that there is.
   */
  std::optional<double> number_of(const std::string &text);

  /**
   * A finite number and nothing else; none if the text is something else.
   */
  std::optional<double> number(const std::string &text);

  /**
   * A number as messages quote that of an entry.
   */
  std::string text_of(const double value);
} // namespace RollingContact

#endif
