#ifndef rolling_contact_base_stopwatch_h
#define rolling_contact_base_stopwatch_h

#include <chrono>

namespace RollingContact
{
  /**
   * Wall seconds since its construction.
   */
  class Stopwatch
  {
  public:
    double
    seconds() const
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                           start)
        .count();
    }

  private:
    std::chrono::steady_clock::time_point start =
      std::chrono::steady_clock::now();
  };
} // namespace RollingContact

#endif
