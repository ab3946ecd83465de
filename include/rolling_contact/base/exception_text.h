#ifndef rolling_contact_base_exception_text_h
#define rolling_contact_base_exception_text_h

#include <sstream>
#include <string>

namespace RollingContact
{
  /**
   * What a deal.II exception says, in one line and without its frame.
   */
  template <typename DealIIException>
  std::string message_of(const DealIIException &error)
  {
    std::ostringstream text;
    error.print_info(text);
    std::string        line, word;
    std::istringstream words(text.str());
    while (words >> word)
      line += (line.empty() ? "" : " ") + word;
    return line;
  }
} // namespace RollingContact

#endif
