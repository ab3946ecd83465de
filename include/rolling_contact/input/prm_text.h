#ifndef rolling_contact_input_prm_text_h
#define rolling_contact_input_prm_text_h

#include <filesystem>
#include <string>

namespace RollingContact
{
  /**
   * The text of a .prm file without a byte order mark, safe for deal.II's
   * reader, which follows `include` without end and takes any value with a '{'.
   * Throws InputError naming the file, and the line where there is one, if it
   * or a file it includes cannot be read, is larger than 16 MiB, or holds a
   * '{' in an entry, or if there are more than 100 inclusions. Included files
   * are relative to the working directory.
   */
  std::string
  read_prm(const std::filesystem::path &file);

  /**
   * What keeps a value from standing in a .prm file; empty if nothing.
   */
  std::string
  problem_of_value(const std::string &value);
} // namespace RollingContact

#endif
