#ifndef rolling_contact_parallel_collective_failure_h
#define rolling_contact_parallel_collective_failure_h

#include <rolling_contact/base/exceptions.h>

#include <string>

namespace RollingContact
{
  /**
   * How a run of several ranks ends when something is thrown: with one message
   * and one exit code, never waiting for a rank that does not come. A failure
   * all ranks have (a wrong entry, a solve that does not converge) is told
   * apart from that of a single one (its memory, its disk) by meeting: the
   * ranks that failed wait a few seconds for the others.
   */
  namespace Ranks
  {
    /** By start(): the meeting has its own communicator. Collective. */
    void
    prepare_common_end();

    /**
     * Whether all ranks failed, with the same exit code. Waits at most about 3
     * s for the others, once: the answer stays. To be asked where an exception
     * is caught and before anything that takes long or needs the other ranks.
     */
    bool
    all_failed(const ExitCode code);

    /**
     * Says what went wrong, on std::cerr, once: by the root if all failed,
     * after it wrote what is worth keeping. Returns the exit code, the same on
     * all ranks. If only some failed, one of them names itself and ends the
     * others with MPI_Abort.
     */
    int
    end_failed_run(const ExitCode code, const std::string &message);

    /** From here on std::terminate() says why and ends all ranks, exit code 3:
     * an exception in a thread or a destructor must not leave them waiting. */
    void
    end_all_on_terminate();
  } // namespace Ranks
} // namespace RollingContact

#endif
