#ifndef rolling_contact_base_stopwatch_h
#define rolling_contact_base_stopwatch_h

#include <chrono>
#include <ctime>

namespace RollingContact
{
  /**
   * Wall and CPU seconds of this process since its construction.
   */
  class Stopwatch
  {
  public:
    double seconds() const
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                           start)
        .count();
    }

    double cpu_seconds() const
    {
      return double(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    }

  private:
    std::chrono::steady_clock::time_point start =
      std::chrono::steady_clock::now();
    std::clock_t cpu_start = std::clock();
  };
} // namespace RollingContact

#endif
