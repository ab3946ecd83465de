#ifndef rolling_contact_input_rows_file_h
#define rolling_contact_input_rows_file_h

#include <filesystem>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A table of numbers, the names of its columns, and those of its rows.
   */
  struct NamedRows
  {
    std::vector<std::string>         names;
    std::vector<std::vector<double>> rows; ///< as many values as names
    std::vector<std::string> titles; ///< of rows, where a column `name` is
  };

  /**
   * Read a CSV file, its columns separated by ',' or ';', whose first line
   * names them; empty lines and those that begin with '#' are skipped. A column
   * `name` holds texts, all others numbers. Throws InputError, beginning with
   * the @p entry that gives the file, if it cannot be read, has no rows, a name
   * of columns or rows twice or none, or a cell that is not a number, naming
   * the line.
   */
  NamedRows read_rows(const std::string           &entry,
                      const std::filesystem::path &file);
} // namespace RollingContact

#endif
