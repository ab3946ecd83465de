#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/rows_file.h>
#include <rolling_contact/input/text_table.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    std::vector<std::string> unquoted_cells(const std::string &line,
                                            const char         separator)
    {
      std::vector<std::string> cells = cells_of(line, separator);
      for (std::string &cell : cells)
        cell = trimmed(cell, " \t\r\"");
      return cells;
    }
  } // namespace

  NamedRows read_rows(const std::string           &entry,
                      const std::filesystem::path &file)
  {
    const std::string place   = entry + " = " + file.string() + ": ",
                      problem = why_unreadable(file);
    if (!problem.empty())
      throw InputError(place + "cannot be read: " + problem +
                       "; give the path of a CSV file.");
    TextLines lines(file);
    if (!lines.next())
      throw InputError(place + "the file is empty; its first line names "
                               "entries, Section/Entry, each other line is a "
                               "state.");
    const char separator = lines.text.find(';') != std::string::npos    ? ';'
                           : lines.text.find(',') != std::string::npos  ? ','
                           : lines.text.find('\t') != std::string::npos ? '\t'
                                                                        : ',';
    NamedRows  found;
    found.names = unquoted_cells(lines.text, separator);
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
    const auto title =
      std::find(found.names.begin(), found.names.end(), "name");
    const std::size_t column_of_titles = title - found.names.begin();
    while (lines.next())
      {
        const std::string at =
          place + "line " + std::to_string(lines.number) + ": ";
        auto cells = unquoted_cells(lines.text, separator);
        if (cells.size() != found.names.size())
          throw InputError(at + "it has " + std::to_string(cells.size()) +
                           " columns, the first line has " +
                           std::to_string(found.names.size()) + ".");
        if (title != found.names.end())
          {
            const std::string name =
              without_apostrophe(cells[column_of_titles]);
            if (name.empty() ||
                std::count(found.titles.begin(), found.titles.end(), name) > 0)
              throw InputError(at + "its name, '" + quotable(name) +
                               "', is empty or that of another row; give each "
                               "one of its own.");
            found.titles.push_back(name);
            cells.erase(cells.begin() + column_of_titles);
          }
        found.rows.emplace_back();
        for (const std::string &cell : cells)
          if (const auto value = number(cell))
            found.rows.back().push_back(*value);
          else
            throw InputError(at + "'" + quotable(cell) + "' is not a number" +
                             advice_on_decimals(cell) + ".");
      }
    if (title != found.names.end())
      found.names.erase(title);
    if (found.names.empty())
      throw InputError(place + "there is no column besides name; name an "
                               "entry, Section/Entry.");
    if (found.rows.empty())
      throw InputError(place +
                       "there is no row below its first line; give a state a "
                       "line.");
    return found;
  }
} // namespace RollingContact
