#ifndef rolling_contact_program_command_line_h
#define rolling_contact_program_command_line_h

#include <string>
#include <utility>
#include <vector>

namespace RollingContact
{
  /**
   * What the user asked for on the command line.
   */
  struct CommandLine
  {
    /**
     * Throws InputError.
     */
    CommandLine(const int argc, const char *const *argv);

    static std::string help();

    struct Setting
    {
      std::string path; ///< Section/Entry, or Entry at the top level
      std::string value;
      std::string place = ""; ///< for messages; empty: that of --set
    };

    std::string              prm_file;
    std::string              output_folder; ///< empty: from the prm file's name
    std::vector<Setting>     settings;
    std::vector<std::string> words; ///< as typed
    bool                     show_help        = false;
    bool                     show_version     = false;
    bool                     validate_only    = false;
    bool                     print_parameters = false;
    bool                     print_json       = false; ///< of the parameters
    bool                     resume           = false;
    bool                     serves_fmu       = false; ///< with its states
  };
} // namespace RollingContact

#endif
