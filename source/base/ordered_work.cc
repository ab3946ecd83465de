#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/ordered_work.h>
#include <rolling_contact/base/platform.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/relayed_exception.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace RollingContact
{
  namespace
  {
    /**
     * Which tasks are begun, done or failed.
     */
    class Board
    {
    public:
      explicit Board(const std::size_t n_tasks)
        : is_done(n_tasks, false)
        , failures(n_tasks)
      {}

      /** The next task to do; false if there is none. */
      bool begin(std::size_t &task)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        task = n_begun;
        if (is_stopped || n_begun == is_done.size())
          return false;
        ++n_begun;
        return true;
      }

      void end(const std::size_t task, const std::exception_ptr &failure)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        is_done[task]  = true;
        failures[task] = failure;
        is_stopped     = is_stopped || failure;
        changed.notify_all();
      }

      void stop()
      {
        const std::lock_guard<std::mutex> lock(mutex);
        is_stopped = true;
        changed.notify_all();
      }

      /** Wait for a task; false if it will not be done, throws what it threw.
       */
      bool wait_for(const std::size_t task)
      {
        std::unique_lock<std::mutex> lock(mutex);
        changed.wait(lock, [&]() {
          return is_done[task] || (is_stopped && task >= n_begun);
        });
        if (!is_done[task])
          return false;
        if (failures[task])
          std::rethrow_exception(failures[task]);
        return true;
      }

    private:
      std::mutex                      mutex;
      std::condition_variable         changed;
      std::vector<bool>               is_done;
      std::vector<std::exception_ptr> failures;
      std::size_t                     n_begun    = 0;
      bool                            is_stopped = false;
    };

    void work_off(
      const std::function<std::function<void(std::size_t)>()> &make_worker,
      Board                                                   &board)
    {
      use_one_solver_thread();
      std::function<void(std::size_t)> work;
      for (std::size_t task = 0; !interrupted() && board.begin(task);)
        {
          std::exception_ptr failure;
          try
            {
              if (!work)
                work = make_worker();
              work(task);
            }
          catch (...)
            {
              failure = std::current_exception();
            }
          board.end(task, failure);
        }
      if (interrupted())
        board.stop();
    }
  } // namespace

  void do_in_order(
    const std::size_t                                        n_tasks,
    const unsigned int                                       n_threads,
    const std::function<std::function<void(std::size_t)>()> &make_worker,
    const std::function<void(std::size_t)>                  &follow)
  {
    Board                    board(n_tasks);
    std::vector<std::thread> threads;
    std::exception_ptr       failure;
    const std::size_t        n_wanted =
      std::max<std::size_t>(1, std::min<std::size_t>(n_threads, n_tasks));
    try
      {
        while (threads.size() < n_wanted)
          threads.emplace_back([&]() { work_off(make_worker, board); });
      }
    catch (const std::system_error &)
      {
        if (threads.empty()) // else fewer do as well
          throw;
      }
    try
      {
        for (std::size_t task = 0; task < n_tasks && board.wait_for(task);
             ++task)
          follow(task);
      }
    catch (...)
      {
        failure = std::current_exception();
      }
    board.stop();
    for (std::thread &thread : threads)
      thread.join();
    if (failure)
      std::rethrow_exception(failure);
    throw_if_interrupted();
  }

  unsigned int rank_of_task(const std::size_t task)
  {
    return task % Ranks::count();
  }

  void do_on_ranks(const std::size_t                       n_tasks,
                   const unsigned int                      n_threads,
                   const std::function<void(std::size_t)> &task,
                   const std::function<void(std::size_t, unsigned int)> &follow)
  {
    std::vector<std::size_t> own;
    for (std::size_t k = 0; k < n_tasks; ++k)
      if (rank_of_task(k) == Ranks::rank())
        own.push_back(k);
    std::vector<RelayedException> failures(n_tasks);
    const auto                    work = [&](const std::size_t k) {
      failures[own[k]] = caught_from([&]() { task(own[k]); });
      rethrow(failures[own[k]]); // so that this rank begins no other one
    };
    Ranks::apart([&]() {
      const auto ended = caught_from([&]() {
        do_in_order(
          own.size(), n_threads, [&]() { return work; }, [](std::size_t) {});
      });
      if (std::all_of(failures.begin(), failures.end(), [](const auto &one) {
            return one.kind == RelayedException::Kind::nothing;
          }))
        rethrow(ended);
    });
    for (std::size_t k = 0; k < n_tasks; ++k)
      {
        Ranks::on(rank_of_task(k), [&]() { rethrow(failures[k]); });
        follow(k, rank_of_task(k));
      }
  }
} // namespace RollingContact
