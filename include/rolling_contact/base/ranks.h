#ifndef rolling_contact_base_ranks_h
#define rolling_contact_base_ranks_h

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The processes of a run under mpirun. All ranks follow the same flow:
   * functions called *collective*, here and elsewhere, are called by every rank
   * in the same order, and never inside on(), where they throw
   * std::logic_error. Before start() a process is the only rank. To be used by
   * one thread only.
   */
  namespace Ranks
  {
    /** Whether a launcher such as mpirun or srun started this process. */
    bool launched();

    /**
     * Start MPI unless it is on. Takes 0.3 s in a process that was not
     * launched, so that runs that need no MPI leave it out. Throws InputError
     * if the launcher belongs to another MPI. Collective.
     */
    void start();

    /** Finalize MPI if start() started it; no MPI after that. Collective. */
    void finish();

    /** Number of ranks. */
    unsigned int count();

    /** Processors of this machine for each rank, as if all ran on it; at
     * least 1. */
    unsigned int cpus_of_each();

    /** Number of this process, from 0 to count() - 1. */
    unsigned int rank();

    /** Whether this is rank 0, which writes the files and the log. */
    bool is_root();

    /** The communicator of all ranks; MPI_COMM_SELF if MPI is off. */
    MPI_Comm communicator();

    /** Sum of the values of all ranks, on all ranks. Collective. */
    double sum(const double value);

    /** Smallest and largest of the values of all ranks, on all ranks.
     * Collective. */
    double minimum(const double value);
    double maximum(const double value);

    /** Replace each entry by its sum over all ranks, which must have equally
     * many entries. Collective. */
    void sum(std::vector<double> &values);

    /** Replace the values or the text of all ranks, size included, by those of
     * rank @p from. For structures see broadcast.h. Collective. */
    void broadcast(std::vector<double> &values, const unsigned int from = 0);
    void broadcast(std::string &text, const unsigned int from = 0);

    /** Whether all ranks have the same text. Collective. */
    bool agree(const std::string &text);

    /**
     * Run the action on one rank while the others sleep until it is done. An
     * exception of the action is thrown on all ranks with its message:
     * InputError, ConvergenceError, Interrupted, std::bad_alloc and
     * std::logic_error with their type, any other as std::runtime_error on the
     * ranks that did not run the action. Collective; inside another on() the
     * action is just called.
     */
    void on(const unsigned int rank, const std::function<void()> &action);

    /** Run the action on rank 0 by on(). Collective. */
    void on_root(const std::function<void()> &action);

    /** Run the action on every rank. If some throw, the exception of the lowest
     * of them is thrown on all ranks, as by on(). Collective. */
    void on_all(const std::function<void()> &action);

    /** Run the action on every rank as if it were the only one, with work of
     * its own, and throw as on_all() does. Inside each is rank 0 of one and the
     * root, so that nothing may be written or told there. Collective. */
    void apart(const std::function<void()> &action);

    /** Whether this call is made inside the action of an on(), while the other
     * ranks wait. */
    bool others_wait();
  } // namespace Ranks
} // namespace RollingContact

#endif
