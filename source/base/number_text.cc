#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>

#include <cmath>
#include <cstdlib>

namespace RollingContact
{
  std::optional<double> number_of(const std::string &text)
  {
    const char *const begin = text.c_str();
    char             *end   = nullptr;
    const double      value = std::strtod(begin, &end);
    if (end == begin || end != begin + text.size())
      return {};
    return value;
  }

  std::optional<double> number(const std::string &text)
  {
    const auto value = number_of(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
  }

  std::string text_of(const double value)
  {
    return significant(value, 15);
  }
} // namespace RollingContact
