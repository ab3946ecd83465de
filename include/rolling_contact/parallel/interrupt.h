#ifndef rolling_contact_parallel_interrupt_h
#define rolling_contact_parallel_interrupt_h

namespace RollingContact
{
  /**
   * Clear the flag of interrupted() and install handlers by which the first
   * SIGINT or SIGTERM only sets it, and a second one of the same kind ends the
   * program at once. A process on its own answers the first with a message; one
   * of several ranks has a second until mpirun kills it, which ends ranks this
   * way also when another one failed: see doc/distributed.md.
   */
  void
  install_interrupt_handlers();

  /** Whether this process received one of the signals; other ranks may not
   * have. */
  bool
  interrupted();

  /**
   * Throw Interrupted on all ranks if any of them is interrupted(). To be
   * called between two states and in solvers that may take minutes. Collective;
   * inside Ranks::on() only the calling rank counts.
   */
  void
  throw_if_interrupted();
} // namespace RollingContact

#endif
