#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rolling_contact/base/child_process.h>
#include <rolling_contact/base/stopwatch.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

namespace RollingContact
{
  namespace fs = std::filesystem;

  fs::path find_program(const std::string &name)
  {
    const char        *variable = std::getenv("PATH");
    std::istringstream folders(variable != nullptr ? variable : "");
    for (std::string folder; std::getline(folders, folder, ':');)
      {
        const fs::path  file = fs::path(folder) / name;
        std::error_code error;
        if (file.is_absolute() && fs::is_regular_file(file, error) &&
            access(file.c_str(), X_OK) == 0)
          return file;
      }
    return {};
  }

  bool run_program(const fs::path                 &program,
                   const std::vector<std::string> &arguments,
                   const fs::path                 &folder,
                   const double                    max_seconds)
  {
    std::vector<char *> words{const_cast<char *>(program.c_str())};
    for (const std::string &argument : arguments)
      words.push_back(const_cast<char *>(argument.c_str()));
    words.push_back(nullptr);

    // what the user has set for gnuplot at a terminal would spoil a picture
    std::vector<char *> environment;
    for (char **entry = environ; *entry != nullptr; ++entry)
      if (std::strncmp(*entry, "GNU", 3) != 0)
        environment.push_back(*entry);
    environment.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDWR, 0);
    posix_spawn_file_actions_adddup2(&actions, 0, 1);
    posix_spawn_file_actions_adddup2(&actions, 0, 2);
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
                                  words.data(),
                                  environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
      return false;

    const Stopwatch watch;
    int             status = 0;
    pid_t           ended  = waitpid(child, &status, WNOHANG);
    while (ended == 0 && watch.seconds() < max_seconds)
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ended = waitpid(child, &status, WNOHANG);
      }
    if (ended == 0)
      {
        kill(-child, SIGKILL);
        while (waitpid(child, &status, 0) < 0 && errno == EINTR)
          ;
      }
    return ended == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
} // namespace RollingContact
