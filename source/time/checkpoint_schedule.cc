#include <rolling_contact/time/checkpoint_schedule.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    constexpr double first_interval = 1.;
    constexpr double growth         = 2.;
    constexpr double least_pause    = 30.; ///< times what a checkpoint took
  }                                        // namespace

  CheckpointSchedule::CheckpointSchedule(const unsigned int steps,
                                         const double       longest_interval)
    : steps(steps)
    , longest_interval(longest_interval)
    , interval(std::min(first_interval, longest_interval))
  {}

  bool CheckpointSchedule::is_due(const std::uint64_t step,
                                  const double        now) const
  {
    return (steps > 0 && step % steps == 0) ||
           (longest_interval > 0. && now - last > interval);
  }

  void CheckpointSchedule::written(const double begin, const double end)
  {
    last     = end;
    interval = std::max(std::min(growth * interval, longest_interval),
                        least_pause * (end - begin));
  }
} // namespace RollingContact
