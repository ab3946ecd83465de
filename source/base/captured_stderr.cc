#include <rolling_contact/base/captured_stderr.h>

namespace RollingContact
{
  std::string
  CapturedStderr::cause() const
  {
    const std::string text = printed.str(), mark = "Additional information:";
    const std::size_t at = text.rfind(mark);
    if (at == std::string::npos)
      return "";
    std::istringstream lines(text.substr(at + mark.size()));
    std::string        line, word, cause;
    std::getline(lines, line);
    while (std::getline(lines, line) &&
           line.find_first_not_of(' ') != std::string::npos)
      for (std::istringstream words(line); words >> word;)
        cause += (cause.empty() ? "" : " ") + word;
    return cause;
  }
} // namespace RollingContact
