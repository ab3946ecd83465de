#include <rolling_contact/base/collective_failure.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/mpi_start.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/relayed_exception.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>
#include <utility>

namespace RollingContact
{
  namespace Ranks
  {
    namespace
    {
      /** Entries of one message: MPI counts with an int, and messages of some
       * megabytes are as fast as larger ones. */
      constexpr std::size_t max_entries = 1 << 20;

      bool started_here = false;
      bool inside_on    = false;
      bool is_apart     = false; ///< others are as if they were not there

      bool is_on()
      {
        int initialised = 0, finalised = 0;
        MPI_Initialized(&initialised);
        MPI_Finalized(&finalised);
        return initialised != 0 && finalised == 0 && !is_apart;
      }

      /** The number in an environment variable; 0 if there is none. */
      unsigned int number_in(const char *variable)
      {
        const char *text = std::getenv(variable);
        return text == nullptr ? 0 : std::strtoul(text, nullptr, 10);
      }

      /** Number of processes that the launcher started; 0 if it does not tell.
       */
      unsigned int launched_size()
      {
        return std::max(number_in("OMPI_COMM_WORLD_SIZE"),
                        number_in("PMI_SIZE"));
      }

      /** Whether there are other ranks. Throws inside on(). */
      bool has_others()
      {
        if (count() == 1)
          return false;
        if (inside_on)
          throw std::logic_error("The other ranks wait in Ranks::on(): there "
                                 "is no collective inside it.");
        return true;
      }

      /** Calls action(pointer to the entries, their number) piece by piece. */
      template <typename Entries, typename Action>
      void in_pieces(Entries &entries, const Action &action)
      {
        for (std::size_t begin = 0; begin < entries.size();
             begin += max_entries)
          action(entries.data() + begin,
                 static_cast<int>(
                   std::min(max_entries, entries.size() - begin)));
      }

      template <typename Entries>
      void broadcast_entries(Entries           &entries,
                             const MPI_Datatype type,
                             const unsigned int from)
      {
        if (!has_others())
          return;
        unsigned long long size = entries.size();
        MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, from, communicator());
        entries.resize(size);
        in_pieces(entries, [&](auto *pointer, const int n) {
          MPI_Bcast(pointer, n, type, from, communicator());
        });
      }

      /** MPI waits at full speed, on cores others may need. */
      void sleep_until_done(MPI_Request request)
      {
        constexpr unsigned int n_eager_tests = 1000;
        int                    done          = 0;
        for (unsigned int n = 0; done == 0; ++n)
          {
            MPI_Test(&request, &done, MPI_STATUS_IGNORE);
            if (done == 0 && n >= n_eager_tests)
              std::this_thread::sleep_for(std::chrono::microseconds(100));
          }
      }

      double reduced(const double value, const MPI_Op operation)
      {
        double result = value;
        if (!has_others())
          return result;
        MPI_Request request;
        MPI_Iallreduce(
          &value, &result, 1, MPI_DOUBLE, operation, communicator(), &request);
        sleep_until_done(request);
        return result;
      }

      /** Throw the exception of one rank on all. Collective. */
      void rethrow_on_all_ranks(RelayedException  &relayed,
                                const unsigned int rank)
      {
        int         kind = static_cast<int>(relayed.kind);
        MPI_Request request;
        MPI_Ibcast(&kind, 1, MPI_INT, rank, communicator(), &request);
        sleep_until_done(request);
        relayed.kind = static_cast<RelayedException::Kind>(kind);
        if (relayed.kind != RelayedException::Kind::nothing)
          broadcast(relayed.message, rank);
        rethrow(relayed);
      }
    } // namespace

    bool launched()
    {
      return launched_size() > 0 || std::getenv("PMIX_RANK") != nullptr ||
             (std::getenv("SLURM_PROCID") != nullptr &&
              number_in("SLURM_NTASKS") > 1);
    }

    void start()
    {
      start_mpi_once([]() {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
        started_here = true;
        set_up_failure_consensus();
        const unsigned int expected = launched_size();
        if (expected > 0 && expected != count())
          throw InputError(
            "The launcher started " + std::to_string(expected) +
            " ranks, MPI knows " + std::to_string(count()) +
            ": take the mpirun of the MPI this program is linked with.");
      });
    }

    void finish()
    {
      if (started_here && is_on())
        MPI_Finalize();
    }

    unsigned int count()
    {
      int size = 1;
      if (is_on())
        MPI_Comm_size(MPI_COMM_WORLD, &size);
      return size;
    }

    unsigned int cpus_of_each()
    {
      return std::max(1u, n_host_cpus() / count());
    }

    unsigned int rank()
    {
      int number = 0;
      if (is_on())
        MPI_Comm_rank(MPI_COMM_WORLD, &number);
      return number;
    }

    bool is_root()
    {
      return rank() == 0;
    }

    MPI_Comm communicator()
    {
      return is_on() ? MPI_COMM_WORLD : MPI_COMM_SELF;
    }

    double sum(const double value)
    {
      return reduced(value, MPI_SUM);
    }

    double minimum(const double value)
    {
      return reduced(value, MPI_MIN);
    }

    double maximum(const double value)
    {
      return reduced(value, MPI_MAX);
    }

    void sum(std::vector<double> &values)
    {
      if (has_others())
        in_pieces(values, [](double *pointer, const int n) {
          MPI_Allreduce(
            MPI_IN_PLACE, pointer, n, MPI_DOUBLE, MPI_SUM, communicator());
        });
    }

    void broadcast(std::vector<double> &values, const unsigned int from)
    {
      broadcast_entries(values, MPI_DOUBLE, from);
    }

    void broadcast(std::string &text, const unsigned int from)
    {
      broadcast_entries(text, MPI_CHAR, from);
    }

    bool agree(const std::string &text)
    {
      std::string of_root = text;
      broadcast(of_root);
      return maximum(of_root != text) == 0.;
    }

    void on(const unsigned int rank, const std::function<void()> &action)
    {
      if (count() == 1 || inside_on)
        {
          action();
          return;
        }
      RelayedException relayed;
      if (Ranks::rank() == rank)
        {
          inside_on = true;
          relayed   = caught_from(action);
          inside_on = false;
        }
      rethrow_on_all_ranks(relayed, rank);
    }

    void on_root(const std::function<void()> &action)
    {
      on(0, action);
    }

    void on_all(const std::function<void()> &action)
    {
      if (!has_others())
        {
          action();
          return;
        }
      RelayedException relayed = caught_from(action);
      const bool       failed = relayed.kind != RelayedException::Kind::nothing;
      const double     first  = minimum(failed ? rank() : count());
      if (first != rank())
        relayed = {};
      if (first < count())
        rethrow_on_all_ranks(relayed, static_cast<unsigned int>(first));
    }

    void apart(const std::function<void()> &action)
    {
      on_all([&]() {
        const bool was_apart = std::exchange(is_apart, true);
        const auto relayed   = caught_from(action);
        is_apart             = was_apart;
        rethrow(relayed);
      });
    }

    bool others_wait()
    {
      return inside_on;
    }
  } // namespace Ranks
} // namespace RollingContact
