#include <rolling_contact/base/collective_failure.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <thread>

namespace RollingContact
{
  namespace Ranks
  {
    namespace
    {
      /** Time for other ranks to fail too, and to write their last files. */
      constexpr double seconds_to_fail  = 3.;
      constexpr double seconds_to_close = 300.;

      enum class Consensus
      {
        not_sought,
        same_failure,
        different_failures, ///< all ranks failed, not all with the same code
        single_failure      ///< some ranks did not fail
      };

      MPI_Comm  consensus_communicator = MPI_COMM_NULL;
      Consensus consensus              = Consensus::not_sought;

      /** Whether all ranks reach this barrier within that time. */
      bool all_ranks_arrive(const double seconds)
      {
        MPI_Request request;
        MPI_Ibarrier(consensus_communicator, &request);
        const Stopwatch watch;
        for (int done = 0; watch.seconds() < seconds;)
          {
            MPI_Test(&request, &done, MPI_STATUS_IGNORE);
            if (done != 0)
              return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
        return false;
      }

      Consensus seek_consensus(const ExitCode code)
      {
        // staggered by rank, so that the first to give up can report for all
        // that failed
        const double stagger = 2. * rank() / count();
        if (!all_ranks_arrive(seconds_to_fail + stagger))
          return Consensus::single_failure;
        int codes[2] = {static_cast<int>(code), -static_cast<int>(code)};
        MPI_Allreduce(
          MPI_IN_PLACE, codes, 2, MPI_INT, MPI_MAX, consensus_communicator);
        return codes[0] == -codes[1] ? Consensus::same_failure
                                     : Consensus::different_failures;
      }

      std::string name_of_rank(const unsigned int rank,
                               const unsigned int count)
      {
        return "rank " + std::to_string(rank) + " of " + std::to_string(count) +
               ": ";
      }

      std::string name_of_this_rank()
      {
        return name_of_rank(rank(), count());
      }

      void print_failure(const std::string &message)
      {
        std::cerr << wrapped("rolling-contact: " + message, screen_width())
                  << std::endl;
      }

      /** Tell the other ranks that failed that this one prints the message. */
      void claim_report()
      {
        for (unsigned int other = 0; other < count(); ++other)
          {
            MPI_Request request;
            MPI_Isend(
              nullptr, 0, MPI_INT, other, 0, consensus_communicator, &request);
            MPI_Request_free(&request);
          }
      }

      bool another_rank_reports()
      {
        int claimed = 0;
        MPI_Iprobe(MPI_ANY_SOURCE,
                   0,
                   consensus_communicator,
                   &claimed,
                   MPI_STATUS_IGNORE);
        return claimed != 0;
      }

      /** End all ranks if this one failed and others did not, or not in time.
       */
      void abort_all_ranks(const ExitCode code, const std::string &message)
      {
        if (another_rank_reports()) // and ends this one meanwhile
          std::this_thread::sleep_for(std::chrono::seconds(10));
        claim_report();
        print_failure(name_of_this_rank() + message);
        MPI_Abort(communicator(), static_cast<int>(code));
      }

      /** Message of the exception that is being handled. */
      std::string current_message()
      {
        try
          {
            if (const auto exception = std::current_exception())
              std::rethrow_exception(exception);
          }
        catch (const std::exception &error)
          {
            return error.what();
          }
        catch (...)
          {}
        return "unknown exception";
      }

      [[noreturn]] void end_terminated_run()
      {
        const std::string message = "internal error: " + current_message();
        const int         code    = static_cast<int>(ExitCode::internal_error);
        // of all ranks, also where this one works apart() from them
        int is_on = 0, size = 1, number = 0;
        MPI_Initialized(&is_on);
        if (is_on != 0)
          {
            MPI_Comm_size(MPI_COMM_WORLD, &size);
            MPI_Comm_rank(MPI_COMM_WORLD, &number);
          }
        print_failure(size > 1 ? name_of_rank(number, size) + message
                               : message);
        if (size > 1)
          MPI_Abort(MPI_COMM_WORLD, code);
        std::_Exit(code);
      }
    } // namespace

    void set_up_failure_consensus()
    {
      MPI_Comm_dup(communicator(), &consensus_communicator);
    }

    bool all_ranks_failed(const ExitCode code)
    {
      if (consensus_communicator == MPI_COMM_NULL)
        return true;
      if (consensus == Consensus::not_sought)
        consensus = seek_consensus(code);
      return consensus == Consensus::same_failure;
    }

    int end_failed_run(const ExitCode code, const std::string &message)
    {
      bool same_failure = true;
      if (consensus_communicator != MPI_COMM_NULL)
        {
          same_failure = all_ranks_failed(code);
          if (consensus == Consensus::single_failure ||
              !all_ranks_arrive(seconds_to_close))
            abort_all_ranks(code, message);
        }
      if (is_root())
        print_failure(same_failure ? message : name_of_this_rank() + message);
      int exit_code = static_cast<int>(code);
      if (consensus_communicator != MPI_COMM_NULL)
        MPI_Bcast(&exit_code, 1, MPI_INT, 0, consensus_communicator);
      return exit_code;
    }

    void abort_all_ranks_on_terminate()
    {
      std::set_terminate(&end_terminated_run);
    }
  } // namespace Ranks
} // namespace RollingContact
