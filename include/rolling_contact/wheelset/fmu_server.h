#ifndef rolling_contact_wheelset_fmu_server_h
#define rolling_contact_wheelset_fmu_server_h

#include <rolling_contact/scene/situation.h>

namespace RollingContact
{
  /**
   * Solves the states of both wheels of a wheelset for an FMU, which asks at
   * the other end of the standard input, a socket; both at once, if
   * Table/Threads is not 1. Returns when the other end is gone. A state that is
   * not to be had is told, with the reason. Throws InputError unless the
   * standard input is a socket and the scene one of an FMU, Interrupted after a
   * signal.
   */
  void serve_fmu(const Situation &scene);
} // namespace RollingContact

#endif
