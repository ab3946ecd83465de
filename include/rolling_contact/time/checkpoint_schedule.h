#ifndef rolling_contact_time_checkpoint_schedule_h
#define rolling_contact_time_checkpoint_schedule_h

#include <cstdint>

namespace RollingContact
{
  /**
   * When a transient run writes its checkpoints. By wall time the first is due
   * after a second and each following after twice the time, up to the longest
   * interval: a run that is killed loses half of what it did or, later, that
   * interval. The interval is never shorter than 30 times what the last
   * checkpoint took, so that they cost 3 % of the time at most. By number of
   * steps they come whatever they cost. Knows no clock. Units: s of wall time
   * since the first step.
   */
  class CheckpointSchedule
  {
  public:
    /** Every so many steps and at least as often as this longest interval, as
     * Time/Checkpoint interval and seconds; 0 for never. */
    CheckpointSchedule(const unsigned int steps, const double longest_interval);

    /** Whether one is due after this step, at this time. */
    bool is_due(const std::uint64_t step, const double now) const;

    /** One was written from @p begin to @p end. */
    void written(const double begin, const double end);

  private:
    const unsigned int steps;
    const double       longest_interval;
    double             interval;
    double             last = 0.;
  };
} // namespace RollingContact

#endif
