#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rolling_contact/base/child_process.h>
#include <rolling_contact/base/stopwatch.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

namespace RollingContact
{
  namespace fs = std::filesystem;

  namespace
  {
    /** The words that posix_spawn() takes; they live as long as the texts. */
    std::vector<char *> words_of(std::vector<std::string> &texts)
    {
      std::vector<char *> words;
      for (std::string &text : texts)
        words.push_back(text.data());
      words.push_back(nullptr);
      return words;
    }

    std::vector<std::string>
    environment_without(const std::vector<std::string> &beginnings)
    {
      std::vector<std::string> kept;
      for (char **entry = environ; entry && *entry; ++entry)
        {
          const auto begins = [&](const std::string &begin) {
            return std::strncmp(*entry, begin.c_str(), begin.size()) == 0;
          };
          if (std::none_of(beginnings.begin(), beginnings.end(), begins))
            kept.push_back(*entry);
        }
      return kept;
    }
  } // namespace

  bool is_executable(const fs::path &file)
  {
    std::error_code error;
    return fs::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0;
  }

  fs::path find_program(const std::string &name)
  {
    const char        *variable = std::getenv("PATH");
    std::istringstream folders(variable != nullptr ? variable : "");
    for (std::string folder; std::getline(folders, folder, ':');)
      {
        const fs::path file = fs::path(folder) / name;
        if (file.is_absolute() && is_executable(file))
          return file;
      }
    return {};
  }

  int start_program(const fs::path                 &program,
                    const std::vector<std::string> &arguments,
                    const std::vector<std::string> &not_in_environment,
                    const std::array<int, 3>       &streams,
                    const fs::path                 &folder)
  {
    std::vector<std::string> texts{program.string()};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables =
      environment_without(not_in_environment);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (int k = 0; k < 3; ++k)
      posix_spawn_file_actions_adddup2(&actions, streams[k], k);
    if (!folder.empty())
      posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // a group of its own: to be killed whole, and not by the terminal; signals
    // as in a new process, whatever this one blocks or ignores
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK |
                               POSIX_SPAWN_SETSIGDEF);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);

    pid_t     child = -1;
    const int error = posix_spawn(&child,
                                  program.c_str(),
                                  &actions,
                                  &attributes,
                                  words_of(texts).data(),
                                  words_of(variables).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    errno = error;
    return error == 0 ? child : -1;
  }

  std::optional<int> wait_for_program(const int process, const double seconds)
  {
    if (process <= 0) // these would be groups, or all there are
      return {};
    const Stopwatch watch;
    int             status = 0;
    pid_t           ended  = waitpid(process, &status, WNOHANG);
    while (ended == 0 && watch.seconds() < seconds)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ended = waitpid(process, &status, WNOHANG);
      }
    if (ended == 0)
      {
        kill(-process, SIGKILL);
        do
          ended = waitpid(process, &status, 0);
        while (ended < 0 && errno == EINTR);
      }
    if (ended != process)
      return {};
    return status;
  }

  bool run_program(const fs::path                 &program,
                   const std::vector<std::string> &arguments,
                   const fs::path                 &folder,
                   const double                    max_seconds)
  {
    const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nothing < 0)
      return false;
    // what the user has set for gnuplot at a terminal would spoil a picture
    const int child = start_program(
      program, arguments, {"GNU"}, {{nothing, nothing, nothing}}, folder);
    close(nothing);
    const auto status = wait_for_program(child, max_seconds);
    return status && WIFEXITED(*status) && WEXITSTATUS(*status) == 0;
  }
} // namespace RollingContact
