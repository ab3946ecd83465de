#ifndef rolling_contact_input_prm_text_h
#define rolling_contact_input_prm_text_h

#include <filesystem>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * A line `set Entry = value` of a .prm file, or of one that it includes.
   */
  struct PrmEntry
  {
    std::string path;  ///< Section/Entry, or Entry at the top level
    std::string value; ///< without blanks around it
    std::string place; ///< "FILE: line 3: "
  };

  /**
   * A .prm file as it was found.
   */
  struct PrmText
  {
    std::string           text;     ///< of the file, without a byte order mark
    std::vector<PrmEntry> entries;  ///< in their order, includes in place
    std::vector<PrmEntry> sections; ///< as they are entered, without value
  };

  /**
   * Read a .prm file and the files that it includes. Unlike deal.II's reader
   * this does not follow `include` without end, and it takes no value with a
   * '{' and no entry twice in one file. Included files are relative to the
   * folder of the file that includes them, which may override their entries.
   *
   * Throws InputError naming the file, and the line if there is one, if a file
   * cannot be read, is no regular file, is larger than 16 MiB or holds bytes
   * that are no text; if a line is none of a .prm file, an entry has a '{' or
   * is given twice, or a section is not ended; and if there are more than 100
   * inclusions.
   */
  PrmText read_prm(const std::filesystem::path &file);

  /**
   * A text as that of a .prm file, see read_prm(); @p name stands for it in
   * messages.
   */
  PrmText read_prm_text(const std::string &text, const std::string &name);

  /**
   * What keeps a value from standing in a .prm file; empty if nothing.
   */
  std::string problem_of_value(const std::string &value);
} // namespace RollingContact

#endif
