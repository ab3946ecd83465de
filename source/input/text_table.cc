#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/text_table.h>

#include <algorithm>
#include <sstream>

namespace RollingContact
{
  std::vector<std::string> cells_of(const std::string &line, char separator)
  {
    const std::size_t found = line.find_first_of(",;");
    if (separator == 0 && found != std::string::npos)
      separator = line[found];
    std::vector<std::string> cells;
    std::istringstream       parts(separator == 0 ? line : line + separator);
    if (separator == 0)
      for (std::string word; parts >> word;)
        cells.push_back(word);
    else
      for (std::string part; std::getline(parts, part, separator);)
        cells.push_back(trimmed(part));
    return cells;
  }

  std::string cure_of_decimal_commas(const std::string &text)
  {
    if (text.find(',') == std::string::npos)
      return "";
    std::string points = text;
    std::replace(points.begin(), points.end(), ';', ' ');
    std::replace(points.begin(), points.end(), ',', '.');
    for (const std::string &word : cells_of(points))
      if (word.back() == '.' || !number(word))
        return "";
    return "; decimals take a point: convert the file, as by `tr , . <OLD "
           ">NEW`";
  }

  std::string advice_on_decimals(const std::string &text)
  {
    const std::string cure = cure_of_decimal_commas(text);
    return cure.empty() ? "; decimals take a point" : cure;
  }

  TextLines::TextLines(const std::filesystem::path &file, const char *marks)
    : stream(file)
    , marks(marks)
  {}

  bool TextLines::next()
  {
    while (std::getline(stream, text))
      {
        if (++number == 1 && text.compare(0, 3, "\xEF\xBB\xBF") == 0)
          text.erase(0, 3);
        text = trimmed(text.substr(0, text.find_first_of(marks)));
        if (!text.empty())
          return true;
      }
    return false;
  }
} // namespace RollingContact
