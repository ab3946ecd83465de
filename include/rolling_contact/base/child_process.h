#ifndef rolling_contact_base_child_process_h
#define rolling_contact_base_child_process_h

#include <filesystem>
#include <string>
#include <vector>

namespace RollingContact
{
  /** The executable file of that name in the first absolute folder of PATH that
   * has one; empty if none has. */
  std::filesystem::path find_program(const std::string &name);

  /**
   * Runs a program in a folder, without a shell, and waits until it ends. What
   * it says is dropped. Returns whether it ended by itself with exit code 0;
   * after max_seconds it is killed, with the processes it started.
   */
  bool run_program(const std::filesystem::path    &program,
                   const std::vector<std::string> &arguments,
                   const std::filesystem::path    &folder,
                   double                          max_seconds);
} // namespace RollingContact

#endif
