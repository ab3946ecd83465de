#include <rolling_contact/base/number_text.h>

#include <cstdlib>

namespace RollingContact
{
  std::optional<double>
  number_of(const std::string &text)
  {
    const char *const begin = text.c_str();
    char             *end   = nullptr;
    const double      value = std::strtod(begin, &end);
    if (end == begin || end != begin + text.size())
      return {};
    return value;
  }
} // namespace RollingContact
