#include <rolling_contact/base/text.h>
#include <rolling_contact/base/xml_text.h>

namespace RollingContact
{
  std::string xml_escaped(const std::string &text)
  {
    std::string result;
    for (const char character : valid_utf8(text))
      if (character == '&')
        result += "&amp;";
      else if (character == '<')
        result += "&lt;";
      else if (character == '"')
        result += "&quot;";
      else
        result += character;
    return result;
  }
} // namespace RollingContact
