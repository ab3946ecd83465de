#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/rows_file.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace RollingContact
{
  namespace
  {
    std::string
    trimmed(const std::string &text)
    {
      const std::string blanks = " \t\r\"";
      const std::size_t begin  = text.find_first_not_of(blanks),
                        end    = text.find_last_not_of(blanks);
      return begin == std::string::npos ? ""
                                        : text.substr(begin, end - begin + 1);
    }



    std::vector<std::string>
    cells_of(const std::string &line, const char separator)
    {
      std::vector<std::string> cells;
      std::istringstream       parts(line + separator);
      for (std::string part; std::getline(parts, part, separator);)
        cells.push_back(trimmed(part));
      return cells;
    }



    /**
     * Lines that say something, with their number and without a byte order
     * mark.
     */
    class Lines
    {
    public:
      explicit Lines(const std::filesystem::path &file)
        : stream(file)
      {}

      bool
      next(std::string &line)
      {
        while (std::getline(stream, line))
          {
            if (++number == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
              line.erase(0, 3);
            const std::string content = trimmed(line);
            if (!content.empty() && content[0] != '#')
              return true;
          }
        return false;
      }

      unsigned int number = 0;

    private:
      std::ifstream stream;
    };



    double
    number_in(const std::string &cell, const std::string &place)
    {
      const auto value = number_of(cell);
      if (!value || !std::isfinite(*value))
        throw InputError(place + "'" + quotable(cell) +
                         "' is no number; decimals take a point.");
      return *value;
    }
  } // namespace



  NamedRows
  read_rows(const std::string &entry, const std::filesystem::path &file)
  {
    const std::string place   = entry + " = " + file.string() + ": ",
                      problem = why_unreadable(file);
    if (!problem.empty())
      throw InputError(place + "cannot be read: " + problem +
                       "; give the path of a CSV file.");
    Lines       lines(file);
    std::string line;
    if (!lines.next(line))
      throw InputError(place + "the file is empty; its first line names "
                               "entries, Section/Entry, each other line is a "
                               "state.");
    const char separator = line.find(';') != std::string::npos    ? ';'
                           : line.find(',') != std::string::npos  ? ','
                           : line.find('\t') != std::string::npos ? '\t'
                                                                  : ',';
    NamedRows  found;
    found.names = cells_of(line, separator);
    for (std::size_t k = 0; k < found.names.size(); ++k)
      {
        const std::string &name = found.names[k];
        if (name.empty())
          throw InputError(place + "column " + std::to_string(k + 1) +
                           " has no name; name an entry, Section/Entry.");
        if (std::count(found.names.begin(), found.names.end(), name) > 1)
          throw InputError(place + quotable(name) +
                           " names two columns; give each entry one.");
      }
    while (lines.next(line))
      {
        const std::string at =
          place + "line " + std::to_string(lines.number) + ": ";
        const auto cells = cells_of(line, separator);
        if (cells.size() != found.names.size())
          throw InputError(at + "it has " + std::to_string(cells.size()) +
                           " columns, the first line has " +
                           std::to_string(found.names.size()) + ".");
        found.rows.emplace_back();
        for (const std::string &cell : cells)
          found.rows.back().push_back(number_in(cell, at));
      }
    if (found.rows.empty())
      throw InputError(place +
                       "there is no row below its first line; give a state a "
                       "line.");
    return found;
  }
} // namespace RollingContact
