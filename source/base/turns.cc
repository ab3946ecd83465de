#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/turns.h>

#include <mutex>

namespace RollingContact
{
  namespace Ranks
  {
    namespace
    {
      /// above all numbers that are taken
      constexpr long end_of_all = 1L << 40;

      /** Whether all ranks run on this machine; the same on all of them. */
      bool on_one_machine()
      {
        MPI_Comm here;
        MPI_Comm_split_type(
          communicator(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
        int n_here = 0;
        MPI_Comm_size(here, &n_here);
        MPI_Comm_free(&here);
        return n_here == static_cast<int>(count());
      }
    } // namespace

    /**
     * The count of numbers taken, of the root if all see it, else of each rank.
     */
    struct Turns::Counter
    {
      Counter()
        : stride(count())
        , own(rank())
      {
        if (stride == 1 || !on_one_machine())
          return;
        long *memory = nullptr;
        MPI_Win_allocate(sizeof(long),
                         sizeof(long),
                         MPI_INFO_NULL,
                         communicator(),
                         &memory,
                         &window);
        *memory = 0;
        MPI_Win_lock_all(0, window);
        MPI_Win_sync(window);
        MPI_Barrier(communicator());
      }

      ~Counter()
      {
        if (window == MPI_WIN_NULL)
          return;
        MPI_Win_unlock_all(window);
        MPI_Win_free(&window);
      }

      /** Add to the count of the root, and return what it was before. */
      long add(const long number)
      {
        long before = 0;
        MPI_Fetch_and_op(&number, &before, MPI_LONG, 0, 0, MPI_SUM, window);
        MPI_Win_flush(0, window);
        return before;
      }

      bool is_stopped()
      {
        return (window != MPI_WIN_NULL ? add(0) : own) >= end_of_all;
      }

      /** Whether the next number for this rank is below @p end. */
      bool has_below(const std::size_t end)
      {
        if (!in_hand)
          in_hand = next();
        return *in_hand < static_cast<long>(end) && !is_stopped();
      }

      long next()
      {
        if (window != MPI_WIN_NULL)
          return add(1);
        const long number = own;
        own += stride;
        return number;
      }

      std::mutex          mutex;
      std::optional<long> in_hand; ///< taken, and not given away yet

      MPI_Win    window = MPI_WIN_NULL;
      const long stride;
      long       own; ///< the next number where ranks do not share them
    };

    Turns::Turns()
      : counter(std::make_unique<Counter>())
    {}

    Turns::~Turns() = default;

    std::optional<std::size_t> Turns::take_below(const std::size_t end)
    {
      const std::lock_guard<std::mutex> lock(counter->mutex);
      if (!counter->has_below(end))
        return {};
      const long number = *counter->in_hand;
      counter->in_hand.reset();
      return number;
    }

    bool Turns::has_below(const std::size_t end)
    {
      const std::lock_guard<std::mutex> lock(counter->mutex);
      return counter->has_below(end);
    }

    void Turns::stop()
    {
      const std::lock_guard<std::mutex> lock(counter->mutex);
      if (counter->window != MPI_WIN_NULL)
        counter->add(end_of_all);
      else
        counter->own = end_of_all;
      counter->in_hand = end_of_all;
    }

    bool Turns::stopped()
    {
      const std::lock_guard<std::mutex> lock(counter->mutex);
      return counter->is_stopped();
    }
  } // namespace Ranks
} // namespace RollingContact
