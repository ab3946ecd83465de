#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rolling_contact/fmu/frames.h>
#include <rolling_contact/fmu/program_process.h>
#include <rolling_contact/fmu/state_messages.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

extern char **environ;

namespace RollingContact::Fmu
{
  namespace
  {
    const char name_of_program[] = "rolling-contact";
    const char variable[]        = "ROLLING_CONTACT_PROGRAM";
    const long most_words        = 1500; ///< bytes of a message

    const unsigned int most_seconds_to_begin = 60;

    bool is_executable(const std::string &file)
    {
      struct stat status;
      return stat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
             access(file.c_str(), X_OK) == 0;
    }

    std::string on_path()
    {
      const char        *path = std::getenv("PATH");
      std::istringstream folders(path ? path : "");
      for (std::string folder; std::getline(folders, folder, ':');)
        if (folder.compare(0, 1, "/") == 0 &&
            is_executable(folder + '/' + name_of_program))
          return folder + '/' + name_of_program;
      return "";
    }

    /** The environment but for what is of this process alone. */
    std::vector<char *> environment_of_program()
    {
      std::vector<char *> all;
      for (char **entry = environ; entry && *entry; ++entry)
        {
          bool is_own = false;
          for (const char *begin : {"LD_LIBRARY_PATH=",
                                    "LD_PRELOAD=",
                                    "OMPI_",
                                    "PMIX_",
                                    "PMI_",
                                    "PRTE_",
                                    "SLURM_"})
            is_own =
              is_own || std::strncmp(*entry, begin, std::strlen(begin)) == 0;
          if (!is_own)
            all.push_back(*entry);
        }
      all.push_back(nullptr);
      return all;
    }

    /** How a process ended, by what waitpid() says of it. */
    std::string end_of(const int status)
    {
      if (WIFSIGNALED(status))
        return std::string("was ended by the signal ") +
               std::to_string(WTERMSIG(status)) + " (" +
               strsignal(WTERMSIG(status)) + ')';
      return "ended with the exit code " + std::to_string(WEXITSTATUS(status));
    }

    /** Waits for a process, which is killed if it does not end by itself in a
     * while; in words. */
    std::string waited_for(const int process)
    {
      const unsigned int pause_us = 10000, most_pauses = 300;
      int                status = 0;
      if (process <= 0) // none, or what would stand for many
        return "has ended";
      for (unsigned int k = 0;; ++k)
        {
          const pid_t ended =
            waitpid(process, &status, k < most_pauses ? WNOHANG : 0);
          if (ended == process)
            return end_of(status);
          if (ended < 0 && errno != EINTR)
            return "has ended"; // somebody else waited for it
          if (k + 1 == most_pauses)
            kill(process, SIGKILL);
          usleep(pause_us);
        }
    }
  } // namespace

  std::string program_of_states(const std::string &asked,
                                const std::string &known)
  {
    const char       *named = std::getenv(variable);
    const std::string given = !asked.empty() ? asked : named ? named : "";
    if (!given.empty())
      {
        if (is_executable(given))
          return given;
        throw std::runtime_error(
          given + ", which " +
          (!asked.empty() ? "the parameter program" : variable) +
          " names, is no program that can be run");
      }
    if (is_executable(known))
      return known;
    const std::string found = on_path();
    if (found.empty())
      throw std::runtime_error(
        std::string("the program ") + name_of_program +
        ", which solves the states of this FMU, is not installed: it is "
        "neither " +
        known +
        " nor in a folder of PATH; give its path as the parameter "
        "program or as the environment variable " +
        variable);
    return found;
  }

  ProgramProcess::ProgramProcess(const std::string &program,
                                 const std::string &scene)
    : program(program)
    , screen(std::tmpfile())
  {
    if (!screen)
      throw std::runtime_error("there is no place for temporary files");
    start(scene);
    unsigned int seconds  = 0;
    const auto   greeting = receive_frame(socket, [&]() {
      return ++seconds == most_seconds_to_begin;
    });
    try
      {
        if (!greeting)
          throw_ended();
        if (*greeting != greeting_of_states)
          throw std::runtime_error(program + " is a program of another version "
                                             "than this FMU");
      }
    catch (...)
      {
        close(socket);
        if (process > 0)
          waited_for(process);
        throw;
      }
  }

  void ProgramProcess::start(const std::string &scene)
  {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::runtime_error("there is no socket to be had");
    std::vector<std::string> words{program, scene, option_of_states};
    std::vector<char *>      arguments;
    for (std::string &word : words)
      arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::vector<char *> environment = environment_of_program();

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
    posix_spawn_file_actions_adddup2(&actions, fileno(screen.get()), 1);
    posix_spawn_file_actions_adddup2(&actions, fileno(screen.get()), 2);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // no signals of a terminal, and those of a new process
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
                                  arguments.data(),
                                  environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (error != 0)
      {
        close(ends[0]);
        throw std::runtime_error(program +
                                 " cannot be run: " + std::strerror(error));
      }
    socket  = ends[0];
    process = child;
  }

  ProgramProcess::~ProgramProcess()
  {
    close(socket); // it ends at that
    if (process > 0)
      {
        kill(process, SIGKILL);
        waited_for(process);
      }
  }

  std::string ProgramProcess::last_words() const
  {
    std::fseek(screen.get(), 0, SEEK_END);
    const long size = std::ftell(screen.get());
    std::fseek(screen.get(),
               size > most_words ? size - most_words : 0,
               SEEK_SET);
    std::string words(static_cast<std::size_t>(most_words), '\0');
    words.resize(std::fread(words.data(), 1, words.size(), screen.get()));
    while (!words.empty() && (words.back() == '\n' || words.back() == ' '))
      words.pop_back();
    return words;
  }

  void ProgramProcess::throw_ended()
  {
    const std::string how  = waited_for(process);
    process                = -1;
    const std::string said = last_words();
    throw std::runtime_error(program + ", which solves the states, " + how +
                             (said.empty() ? "" : ". It said: " + said));
  }

  std::string ProgramProcess::exchange(const std::string &question)
  {
    if (process > 0 && send_frame(socket, question))
      if (auto answer = receive_frame(socket))
        return std::move(*answer);
    if (process <= 0)
      throw std::runtime_error(program + " has ended");
    throw_ended();
  }
} // namespace RollingContact::Fmu
