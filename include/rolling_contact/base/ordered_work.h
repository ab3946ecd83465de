#ifndef rolling_contact_base_ordered_work_h
#define rolling_contact_base_ordered_work_h

#include <cstddef>
#include <functional>

namespace RollingContact
{
  /**
   * Do the tasks 0, 1, ..., @p n_tasks - 1 in several threads of this process,
   * each with one thread for linear algebra, and for each in this order what
   * follows it in the calling thread, as soon as those before are done.
   * @p make_worker is called in each thread and returns what does a task there.
   * When a task or @p follow throws, or this process is interrupted(), no more
   * tasks are begun, and once all threads have ended the exception is thrown,
   * that of the lowest task; what follows the tasks below it was done.
   */
  void do_in_order(
    const std::size_t                                        n_tasks,
    const unsigned int                                       n_threads,
    const std::function<std::function<void(std::size_t)>()> &make_worker,
    const std::function<void(std::size_t)>                  &follow);

  /**
   * Do the tasks 0, 1, ..., @p n_tasks - 1, each on one of the ranks, which is
   * always the same one for a number, in several threads of each; and then for
   * each in this order, on all ranks, what follows it, which is told the rank
   * that did it. Throws on all ranks what the lowest task that fails threw.
   * Collective; the tasks are not, see Ranks::apart(). A rank begins no more of
   * them once one of its own has failed or it is interrupted().
   */
  void
  do_on_ranks(const std::size_t                                     n_tasks,
              const unsigned int                                    n_threads,
              const std::function<void(std::size_t)>               &task,
              const std::function<void(std::size_t, unsigned int)> &follow);

  /** The rank on which do_on_ranks() does a task. */
  unsigned int rank_of_task(const std::size_t task);
} // namespace RollingContact

#endif
