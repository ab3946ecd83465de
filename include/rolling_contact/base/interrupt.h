#ifndef rolling_contact_base_interrupt_h
#define rolling_contact_base_interrupt_h

namespace RollingContact
{
  /**
   * From here on the first SIGINT or SIGTERM only sets a flag, and a second one
   * of the same kind ends the program at once. Clears the flag.
   */
  void
  install_interrupt_handlers();

  /** Whether this process got one of the signals; other MPI ranks may not. */
  bool
  interrupted();

  /** Throws Interrupted if interrupted(); to be called between two states and
   * in solvers that may take minutes. */
  void
  throw_if_interrupted();
} // namespace RollingContact

#endif
