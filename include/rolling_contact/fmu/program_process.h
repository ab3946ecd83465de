#ifndef rolling_contact_fmu_program_process_h
#define rolling_contact_fmu_program_process_h

#include <cstdio>
#include <memory>
#include <string>

namespace RollingContact::Fmu
{
  /**
   * The executable of the program that solves states for FMUs: the one that is
   * @p asked for; else that of the environment variable
   * ROLLING_CONTACT_PROGRAM; else the one that is @p known, if it is there;
   * else rolling-contact of a folder of PATH. Throws std::runtime_error that
   * names all places if there is none.
   */
  std::string program_of_states(const std::string &asked,
                                const std::string &known);

  /**
   * The program in a process of its own that solves states of a scene. It is
   * asked through a socket, and what it writes to its screen is kept for
   * messages. It gets neither the libraries that this process prefers
   * (LD_LIBRARY_PATH, LD_PRELOAD) nor its place among ranks of MPI. It ends
   * with this object, and with this process, however that ends.
   */
  class ProgramProcess
  {
  public:
    /** Waits until it is ready. Throws std::runtime_error with its own last
     * words if it does not begin. */
    ProgramProcess(const std::string &program, const std::string &scene);

    ~ProgramProcess();

    ProgramProcess(const ProgramProcess &)            = delete;
    ProgramProcess &operator=(const ProgramProcess &) = delete;

    /** What it answers. Throws std::runtime_error with its last words if it
     * ends instead; it is of no use then. */
    std::string exchange(const std::string &question);

  private:
    void start(const std::string &scene);

    /** Throws with the reason of the end. */
    [[noreturn]] void throw_ended();

    /** The last of what it wrote to its screen. */
    std::string last_words() const;

    struct Closer
    {
      void operator()(std::FILE *file) const
      {
        std::fclose(file);
      }
    };

    const std::string                  program;
    std::unique_ptr<std::FILE, Closer> screen;
    int                                socket = -1, process = -1;
  };
} // namespace RollingContact::Fmu

#endif
