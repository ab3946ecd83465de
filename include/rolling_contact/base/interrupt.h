#ifndef rolling_contact_base_interrupt_h
#define rolling_contact_base_interrupt_h

#include <filesystem>
#include <functional>
#include <string>

namespace RollingContact
{
  /**
   * Clear the flag of interrupted() and follow SIGINT, SIGTERM, SIGXCPU,
   * SIGUSR1 and, unless it is ignored as under nohup, SIGHUP from now on:
   * the first only sets the flag, the second ends the process at once, as does
   * one but SIGINT not heard within seconds_to_stop (not under a launcher,
   * which kills by itself): exit code 2, and the file of leave_on_stop(). A
   * process on its own answers the first with a message. A SIGXCPU is never a
   * second one: the kernel sends it every second.
   *
   * A thread of its own waits for them, and they are blocked in all others,
   * whatever a library installs: METIS jumps out of its own code on a SIGTERM.
   * So call it before other threads are started. SIGPIPE and SIGXFSZ are
   * ignored: a run goes on without its screen, and a file that is too large is
   * an error of writing it.
   */
  void install_interrupt_handlers();

  /** How long after a SIGTERM a process ends that does not stop by itself; a
   * container is killed after 10 s. */
  inline constexpr int seconds_to_stop = 8;

  /** Whether this process received one of the signals; other ranks may not
   * have. */
  bool interrupted();

  /**
   * Throw Interrupted on all ranks if any of them is interrupted(). To be
   * called between two states and in solvers that may take minutes. Collective;
   * inside Ranks::on() only the calling rank counts.
   */
  void throw_if_interrupted();

  /**
   * throw_if_interrupted() where ranks do different things, as in the making of
   * bodies: does nothing with several ranks.
   */
  void throw_if_interrupted_alone();

  /**
   * What throw_if_interrupted() calls first, for a program that follows signals
   * by itself, as an interpreter does: it throws Interrupted if the solve is to
   * end. Any thread may call it. An empty one asks nobody. To be set before
   * anything is solved.
   */
  void set_interrupt_source(const std::function<void()> &source);

  /**
   * What a process that is ended at once leaves: this text in the file, written
   * under the temporary name first. Replaces what was asked for before; an
   * empty text leaves nothing.
   */
  void leave_on_stop(const std::filesystem::path &file,
                     const std::filesystem::path &temporary,
                     const std::string           &text);
} // namespace RollingContact

#endif
