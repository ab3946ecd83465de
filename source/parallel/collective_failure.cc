#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/parallel/collective_failure.h>
#include <rolling_contact/parallel/ranks.h>

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
      /** For the others to fail too, and to come back from their last files. */
      constexpr double seconds_to_fail  = 3.;
      constexpr double seconds_to_close = 300.;

      enum class Meeting
      {
        not_held,
        all_alike,
        all_different, ///< all failed, each for its own reason
        not_all
      };

      MPI_Comm meeting_place = MPI_COMM_NULL;
      Meeting  meeting       = Meeting::not_held;



      /** Whether all ranks come here within that time. */
      bool
      all_come(const double seconds)
      {
        MPI_Request request;
        MPI_Ibarrier(meeting_place, &request);
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



      Meeting
      meet(const ExitCode code)
      {
        // one after the other: the first one speaks for all that failed
        const double own_turn = 2. * rank() / count();
        if (!all_come(seconds_to_fail + own_turn))
          return Meeting::not_all;
        int codes[2] = {static_cast<int>(code), -static_cast<int>(code)};
        MPI_Allreduce(MPI_IN_PLACE, codes, 2, MPI_INT, MPI_MAX, meeting_place);
        return codes[0] == -codes[1] ? Meeting::all_alike
                                     : Meeting::all_different;
      }



      std::string
      own_name()
      {
        return "rank " + std::to_string(rank()) + " of " +
               std::to_string(count()) + ": ";
      }



      void
      say(const std::string &message)
      {
        std::cerr << wrapped("rolling-contact: " + message) << std::endl;
      }



      /** To the other ranks that failed: one message is enough. */
      void
      take_the_word()
      {
        for (unsigned int other = 0; other < count(); ++other)
          {
            MPI_Request request;
            MPI_Isend(nullptr, 0, MPI_INT, other, 0, meeting_place, &request);
            MPI_Request_free(&request);
          }
      }



      bool
      another_has_the_word()
      {
        int has = 0;
        MPI_Iprobe(MPI_ANY_SOURCE, 0, meeting_place, &has, MPI_STATUS_IGNORE);
        return has != 0;
      }



      /** This rank failed and others did not, or not in time. */
      void
      end_all(const ExitCode code, const std::string &message)
      {
        if (another_has_the_word())
          std::this_thread::sleep_for(std::chrono::seconds(10)); // it ends us
        take_the_word();
        say(own_name() + message);
        MPI_Abort(communicator(), static_cast<int>(code));
      }



      /** Of the exception that is being handled, if any. */
      std::string
      current_message()
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



      [[noreturn]] void
      end_terminated_run()
      {
        const std::string message = "internal error: " + current_message();
        const int         code    = static_cast<int>(ExitCode::internal_error);
        say(count() > 1 ? own_name() + message : message);
        if (count() > 1)
          MPI_Abort(communicator(), code);
        std::_Exit(code);
      }
    } // namespace



    void
    prepare_common_end()
    {
      MPI_Comm_dup(communicator(), &meeting_place);
    }



    bool
    all_failed(const ExitCode code)
    {
      if (meeting_place == MPI_COMM_NULL)
        return true;
      if (meeting == Meeting::not_held)
        meeting = meet(code);
      return meeting == Meeting::all_alike;
    }



    int
    end_failed_run(const ExitCode code, const std::string &message)
    {
      bool alike = true;
      if (meeting_place != MPI_COMM_NULL)
        {
          alike = all_failed(code);
          if (meeting == Meeting::not_all || !all_come(seconds_to_close))
            end_all(code, message);
        }
      if (is_root())
        say(alike ? message : own_name() + message);
      int exit_code = static_cast<int>(code);
      if (meeting_place != MPI_COMM_NULL)
        MPI_Bcast(&exit_code, 1, MPI_INT, 0, meeting_place);
      return exit_code;
    }



    void
    end_all_on_terminate()
    {
      std::set_terminate(&end_terminated_run);
    }
  } // namespace Ranks
} // namespace RollingContact
