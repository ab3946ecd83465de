#ifndef rolling_contact_parallel_interrupt_h
#define rolling_contact_parallel_interrupt_h

namespace RollingContact
{
  /**
   * From here on the first SIGINT or SIGTERM only sets a flag, and a second one
   * of the same kind ends the program at once. Clears the flag. A process on
   * its own answers the first with a message; mpirun, which also ends ranks
   * this way when another one failed, waits for one second: see
   * doc/distributed.md.
   */
  void
  install_interrupt_handlers();

  /** Whether this process got one of the signals; other MPI ranks may not. */
  bool
  interrupted();

  /**
   * Throws Interrupted if any rank is interrupted(), on all of them; to be
   * called between two states and in solvers that may take minutes. Collective,
   * but inside Ranks::on() only the own rank counts.
   */
  void
  throw_if_interrupted();
} // namespace RollingContact

#endif
