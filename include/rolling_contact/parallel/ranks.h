#ifndef rolling_contact_parallel_ranks_h
#define rolling_contact_parallel_ranks_h

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The processes of a run under mpirun. All follow the same flow: what is
   * called collective here is called by every rank, in the same order, and
   * never inside on(), where it throws std::logic_error. Before start() a
   * process is the only rank. To be used by one thread.
   */
  namespace Ranks
  {
    /** Whether mpirun, srun or their like started this process. */
    bool
    launched();

    /**
     * Starts MPI unless it is on; collective. Takes 0.3 s in a process that was
     * not launched, so that runs that need no MPI leave it out. Throws
     * InputError if the launcher belongs to another MPI.
     */
    void
    start();

    /** Ends what start() began, once all ranks are here; no MPI after it. */
    void
    finish();

    /** Number of ranks. */
    unsigned int
    count();

    /** That of this process, below count(). */
    unsigned int
    rank();

    /** Rank 0: it writes the files and talks to the user. */
    bool
    is_root();

    /** All ranks; this process alone if MPI is off. */
    MPI_Comm
    communicator();

    /** Over all ranks, the result on all; collective. */
    double
    sum(const double value);
    double
    minimum(const double value);
    double
    maximum(const double value);

    /** Entry by entry; as many of them on all ranks. Collective. */
    void
    sum(std::vector<double> &values);

    /** The values of one rank, their number included, on all; collective. */
    void
    broadcast(std::vector<double> &values, const unsigned int from = 0);
    void
    broadcast(std::string &text, const unsigned int from = 0);

    /**
     * That rank runs the action, the others wait for it, asleep. What it throws
     * is thrown on all: InputError, ConvergenceError, Interrupted,
     * std::bad_alloc and std::logic_error with their type, anything else as
     * std::runtime_error on the others, all with its message. Collective;
     * inside another on() it just calls the action.
     */
    void
    on(const unsigned int rank, const std::function<void()> &action);

    void
    on_root(const std::function<void()> &action);

    /** Every rank runs the action; what the lowest failing one throws is thrown
     * on all, as by on(). Collective. */
    void
    on_all(const std::function<void()> &action);

    /** Whether this is the action of an on(), with other ranks waiting. */
    bool
    others_wait();
  } // namespace Ranks
} // namespace RollingContact

#endif
