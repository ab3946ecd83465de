#include <fmt/format.h>

#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    /** Number of bytes of the UTF-8 character at `position`; 0 if malformed. */
    std::size_t character_length(const std::string &text,
                                 const std::size_t  position)
    {
      const auto byte = [&](const std::size_t i) -> unsigned int {
        return position + i < text.size()
                 ? static_cast<unsigned char>(text[position + i])
                 : 0;
      };
      const auto continues = [&](const std::size_t i) {
        return (byte(i) & 0xC0) == 0x80;
      };

      if (byte(0) < 0x80)
        return 1;
      if (byte(0) >= 0xC2 && byte(0) < 0xE0)
        return continues(1) ? 2 : 0;

      const unsigned int first_two = 256 * byte(0) + byte(1);
      if (byte(0) >= 0xE0 && byte(0) < 0xF0)
        {
          const bool overlong  = first_two < 0xE0A0;
          const bool surrogate = first_two >= 0xEDA0 && first_two <= 0xEDBF;
          return continues(1) && continues(2) && !overlong && !surrogate ? 3
                                                                         : 0;
        }
      const bool in_range = first_two >= 0xF090 && first_two <= 0xF48F;
      return in_range && continues(1) && continues(2) && continues(3) ? 4 : 0;
    }

    std::string wrapped_line(const std::string &line,
                             const std::size_t  width,
                             const std::size_t  hanging_indentation)
    {
      if (n_characters(line) <= width)
        return line;

      const std::size_t own_indentation =
        std::min(line.find_first_not_of(' '), line.size());
      const std::string indentation(own_indentation + hanging_indentation, ' ');

      std::string        result;
      std::string        current(own_indentation, ' ');
      bool               is_first_word = true;
      std::istringstream words(line);
      for (std::string word; words >> word; is_first_word = false)
        {
          const std::size_t needed = n_characters(current) + 1;
          if (!is_first_word && needed + n_characters(word) > width)
            {
              result += current + '\n';
              current = indentation + word;
            }
          else
            current += (is_first_word ? "" : " ") + word;
        }
      return result + current;
    }
  } // namespace

  std::string significant(const double value, const unsigned int digits)
  {
    const double without_negative_zero = value + 0.;
    return fmt::format("{:.{}g}",
                       without_negative_zero,
                       std::clamp(digits, 1u, 17u));
  }

  std::string scientific(const double value, const unsigned int digits)
  {
    const double without_negative_zero = value + 0.;
    return fmt::format("{:.{}e}",
                       without_negative_zero,
                       std::clamp(digits, 1u, 17u) - 1);
  }

  std::string millimetres(const double length, const unsigned int digits)
  {
    return significant(1e3 * length, digits) + " mm";
  }

  std::string human_bytes(const double bytes)
  {
    const std::array<const char *, 6> units{"B", "kB", "MB", "GB", "TB", "PB"};

    double      value = bytes;
    std::size_t unit  = 0;
    while (value >= 999.5 && unit + 1 < units.size())
      {
        value /= 1000.;
        ++unit;
      }
    return significant(value, 3) + ' ' + units[unit];
  }

  std::string human_seconds(const double seconds)
  {
    if (seconds > 0. && seconds < 0.9995)
      return significant(1000. * seconds, seconds < 0.0995 ? 2 : 3) + " ms";
    if (!(seconds >= 59.95))
      return significant(seconds, 3) + " s";

    const long long whole = std::llround(seconds);
    if (whole < 3600)
      return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    const long long minutes = std::llround(seconds / 60.);
    return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
  }

  std::string trimmed(const std::string &text, const char *blanks)
  {
    const std::size_t begin = text.find_first_not_of(blanks),
                      end   = text.find_last_not_of(blanks);
    return begin == std::string::npos ? ""
                                      : text.substr(begin, end - begin + 1);
  }

  std::string valid_utf8(const std::string &text)
  {
    std::string result;
    for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t length = character_length(text, i);
        result += length > 0 ? text.substr(i, length) : "\xEF\xBF\xBD";
        i += std::max<std::size_t>(length, 1);
      }
    return result;
  }

  std::string quotable(const std::string &text,
                       const std::size_t  most_characters)
  {
    std::string result;
    std::size_t n_shown = 0;
    for (std::size_t i = 0; i < text.size(); ++n_shown)
      {
        if (n_shown == most_characters)
          return result + "...";
        const auto        byte   = static_cast<unsigned char>(text[i]);
        const std::size_t length = character_length(text, i);
        // U+0080 to U+009F are control characters too
        const bool shown = length > 0 && byte >= 0x20 && byte != 0x7F &&
                           !(byte == 0xC2 && text.size() > i + 1 &&
                             static_cast<unsigned char>(text[i + 1]) < 0xA0);
        result +=
          shown ? text.substr(i, length) : fmt::format("\\x{:02X}", byte);
        i += shown ? length : 1;
      }
    return result;
  }

  namespace
  {
    /** Whether it is a formula behind any number of apostrophes. */
    bool is_formula(const std::string &text)
    {
      const std::size_t begin = text.find_first_not_of('\'');
      return begin != std::string::npos &&
             std::string("=+-@\t\r").find(text[begin]) != std::string::npos &&
             !number(text);
    }
  } // namespace

  std::string no_formula(const std::string &text)
  {
    return is_formula(text) ? '\'' + text : text;
  }

  std::string without_apostrophe(const std::string &cell)
  {
    return !cell.empty() && cell[0] == '\'' && is_formula(cell.substr(1))
             ? cell.substr(1)
             : cell;
  }

  std::string zero_padded(const std::size_t number, const unsigned int digits)
  {
    return fmt::format("{:0{}}", number, digits);
  }

  std::size_t n_characters(const std::string &text)
  {
    return std::count_if(text.begin(), text.end(), [](const char byte) {
      return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
    });
  }

  std::string left_aligned(const std::string &text, const std::size_t width)
  {
    return text + std::string(width - std::min(width, n_characters(text)), ' ');
  }

  std::string right_aligned(const std::string &text, const std::size_t width)
  {
    return std::string(width - std::min(width, n_characters(text)), ' ') + text;
  }

  std::string wrapped(const std::string &text,
                      const std::size_t  width,
                      const std::size_t  hanging_indentation)
  {
    std::string        result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      result += wrapped_line(line, width, hanging_indentation) + '\n';

    const bool ends_with_newline = !text.empty() && text.back() == '\n';
    if (!result.empty() && !ends_with_newline)
      result.pop_back();
    return result;
  }
} // namespace RollingContact
