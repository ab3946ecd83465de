#ifndef rolling_contact_base_child_process_h
#define rolling_contact_base_child_process_h

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /** Whether this is a regular file that may be executed. */
  bool is_executable(const std::filesystem::path &file);

  /** The executable file of that name in the first absolute folder of PATH that
   * has one; empty if none has. */
  std::filesystem::path find_program(const std::string &name);

  /**
   * Starts a program without a shell, in a process group of its own, with no
   * signal blocked or ignored, in this folder or, if that is empty, in the
   * present one. It sees the environment but for the variables that begin with
   * these words; @p streams are its input, output and errors. Returns the id of
   * its process, or -1 with errno if it cannot be started.
   */
  int start_program(const std::filesystem::path    &program,
                    const std::vector<std::string> &arguments,
                    const std::vector<std::string> &not_in_environment,
                    const std::array<int, 3>       &streams,
                    const std::filesystem::path    &folder);

  /**
   * Waits until a process of start_program() ends. After these @p seconds it is
   * killed, with the processes it started. Returns how it ended, as waitpid()
   * tells it; nothing if there is no such process.
   */
  std::optional<int> wait_for_program(int process, double seconds);

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
