#ifndef rolling_contact_run_previous_run_h
#define rolling_contact_run_previous_run_h

#include <filesystem>
#include <set>
#include <string>

namespace RollingContact
{
  /** The mark of a folder this program made, see RunFolder. */
  inline const std::string record_name  = "run.json";
  inline const std::string program_name = "rolling-contact";

  /** What run.json tells about the run that left it. */
  struct PreviousRun
  {
    bool                  made_by_this_program = false;
    std::set<std::string> files; ///< of is_written_name() only
  };

  /** Never throws for what the file holds: text that is not JSON, or nested
   * too deeply, is no record of this program. */
  PreviousRun read_previous_run(const std::filesystem::path &folder);

  /** The text of run.json: the program's name, further members as
   * JSON without the outer braces, the files. */
  std::string record_text(const std::string           &members,
                          const std::set<std::string> &files);

  /** Whether a first run died before it could leave its mark, or nothing was
   * ever there. */
  bool is_empty_folder(const std::filesystem::path &folder);
} // namespace RollingContact

#endif
