#ifndef rolling_contact_run_progress_h
#define rolling_contact_run_progress_h

#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/run/log.h>

#include <cstdint>
#include <string>

namespace RollingContact
{
  /**
   * Says how far a loop is and, at the pace since the object was made, how much
   * time is left: "step 40 of 1000, about 2 min 05 s left". At most one line
   * every few seconds, none at the end; short loops say nothing. Does not own
   * the log.
   */
  class Progress
  {
  public:
    Progress(Log                &log,
             const std::string  &name_of_one,
             const std::uint64_t n_total,
             const std::uint64_t n_done_before         = 0,
             const double        seconds_between_lines = 5.);

    void report(const std::uint64_t n_done);

  private:
    Log                &log;
    const std::string   name_of_one;
    const std::uint64_t n_total;
    const std::uint64_t n_done_before;
    const double        seconds_between_lines;
    const Stopwatch     watch;
    double              last_line = 0.; ///< on the watch; s
  };
} // namespace RollingContact

#endif
