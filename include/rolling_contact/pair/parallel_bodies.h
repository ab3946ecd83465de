#ifndef rolling_contact_pair_parallel_bodies_h
#define rolling_contact_pair_parallel_bodies_h

#include <rolling_contact/base/platform.h>

#include <future>

namespace RollingContact
{
  /**
   * Run one action for each body: one after the other on one thread, or at the
   * same time on two, then with one thread each for linear algebra. An
   * exception of either reaches the caller.
   */
  template <typename First, typename Second>
  void for_both_bodies(const unsigned int n_threads,
                       const First       &first,
                       const Second      &second)
  {
    if (n_threads == 1)
      {
        first();
        second();
        return;
      }
    std::future<void> other = std::async(std::launch::async, [&]() {
      use_one_solver_thread();
      second();
    });
    first();
    other.get();
  }
} // namespace RollingContact

#endif
