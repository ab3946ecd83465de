#ifndef rolling_contact_base_collective_failure_h
#define rolling_contact_base_collective_failure_h

#include <rolling_contact/base/exceptions.h>

#include <string>

namespace RollingContact
{
  /**
   * How a run of several ranks ends when something is thrown: with one message
   * and one exit code, and no rank left waiting for another. Ranks that fail
   * reach a consensus: they wait a few seconds for each other to find out
   * whether all failed (a wrong entry, a solve that does not converge) or only
   * some (out of memory, a full disk).
   */
  namespace Ranks
  {
    /** Make the communicator of the consensus, which other messages must not
     * disturb. Called by start(). Collective. */
    void set_up_failure_consensus();

    /**
     * Whether all ranks failed, with the same exit code. The first call waits
     * for the other ranks, about 3 s at most; later calls return the same
     * result at once. Call it where an exception is caught, before anything
     * that takes long or is collective.
     */
    bool all_ranks_failed(const ExitCode code);

    /**
     * End a failed run after all_ranks_failed(), which is called if need be.
     * If all ranks failed, the root prints its @p message on std::cerr once the
     * others have come here too, and all ranks return the root's exit code. If
     * only some failed, one of them prints its message with its rank and ends
     * all ranks by MPI_Abort.
     */
    int end_failed_run(const ExitCode code, const std::string &message);

    /** From here on std::terminate(), after an exception in a thread or a
     * destructor, prints the reason and ends all ranks with exit code 3. */
    void abort_all_ranks_on_terminate();
  } // namespace Ranks
} // namespace RollingContact

#endif
