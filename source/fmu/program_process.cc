#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rolling_contact/base/child_process.h>
#include <rolling_contact/fmu/frames.h>
#include <rolling_contact/fmu/program_process.h>
#include <rolling_contact/fmu/state_messages.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace RollingContact::Fmu
{
  namespace
  {
    const char name_of_program[] = "rolling-contact";
    const char variable[]        = "ROLLING_CONTACT_PROGRAM";
    const long most_words        = 1500; ///< bytes of a message

    const unsigned int most_seconds_to_begin = 60;
    const double       seconds_to_end        = 3.;

    /** What belongs to this process alone: libraries that it prefers, and its
     * place among ranks. */
    const std::vector<std::string> own_variables{"LD_LIBRARY_PATH=",
                                                 "LD_PRELOAD=",
                                                 "OMPI_",
                                                 "PMIX_",
                                                 "PMI_",
                                                 "PRTE_",
                                                 "SLURM_"};

    /** How a process ended, by what waitpid() says of it. */
    std::string end_of(const int status)
    {
      if (WIFSIGNALED(status))
        return std::string("was ended by the signal ") +
               std::to_string(WTERMSIG(status)) + " (" +
               strsignal(WTERMSIG(status)) + ')';
      return "ended with the exit code " + std::to_string(WEXITSTATUS(status));
    }

    /** Waits for a process, which is killed if it does not end by itself in
     * these seconds; in words. */
    std::string waited_for(const int process, const double seconds)
    {
      const auto status = wait_for_program(process, seconds);
      return status ? end_of(*status) : "has ended"; // others waited for it
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
          " names, is not a program that can be run");
      }
    if (is_executable(known))
      return known;
    const std::string found = find_program(name_of_program).string();
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
      throw std::runtime_error("no temporary file can be made");
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
        wait_for_program(process, seconds_to_end);
        throw;
      }
  }

  void ProgramProcess::start(const std::string &scene)
  {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::runtime_error("no socket can be made");
    const int screen_file = fileno(screen.get());
    process               = start_program(program,
                            {scene, option_of_states},
                            own_variables,
                            {{ends[1], screen_file, screen_file}},
                            "");
    const int error       = errno;
    close(ends[1]);
    if (process < 0)
      {
        close(ends[0]);
        throw std::runtime_error(program +
                                 " cannot be run: " + std::strerror(error));
      }
    socket = ends[0];
  }

  ProgramProcess::~ProgramProcess()
  {
    close(socket); // it ends at that
    wait_for_program(process, 0.);
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
    const std::string how  = waited_for(process, seconds_to_end);
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
