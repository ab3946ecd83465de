#include <rolling_contact/fmu/face.h>

#include <algorithm>
#include <cctype>

namespace RollingContact::Fmu
{
  namespace
  {
    int digit_of(const char c)
    {
      const std::string digits = "0123456789abcdef";
      const auto at = digits.find(std::tolower(static_cast<unsigned char>(c)));
      return at == std::string::npos ? -1 : static_cast<int>(at);
    }

    /** "a b" of "a%20b". */
    std::string decoded(const std::string &text)
    {
      std::string result;
      for (std::size_t k = 0; k < text.size(); ++k)
        {
          const bool is_code = text[k] == '%' && k + 2 < text.size() &&
                               digit_of(text[k + 1]) >= 0 &&
                               digit_of(text[k + 2]) >= 0;
          if (!is_code)
            {
              result += text[k];
              continue;
            }
          result += static_cast<char>(16 * digit_of(text[k + 1]) +
                                      digit_of(text[k + 2]));
          k += 2;
        }
      return result;
    }
  } // namespace

  std::string folder_of(const std::string &location)
  {
    const std::string scheme = "file:";
    std::string       path   = location;
    if (location.compare(0, scheme.size(), scheme) == 0)
      {
        path = location.substr(scheme.size());
        if (path.compare(0, 2, "//") == 0) // a host, which is this one
          path.erase(0, std::min(path.find('/', 2), path.size()));
        path = decoded(path);
      }
    while (path.size() > 1 && path.back() == '/')
      path.pop_back();
    return path;
  }
} // namespace RollingContact::Fmu
