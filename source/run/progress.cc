#include <fmt/format.h>

#include <rolling_contact/base/text.h>
#include <rolling_contact/run/progress.h>

namespace RollingContact
{
  Progress::Progress(Log                &log,
                     const std::string  &name_of_one,
                     const std::uint64_t n_total,
                     const std::uint64_t n_done_before,
                     const double        seconds_between_lines)
    : log(log)
    , name_of_one(name_of_one)
    , n_total(n_total)
    , n_done_before(n_done_before)
    , seconds_between_lines(seconds_between_lines)
  {}

  void Progress::report(const std::uint64_t n_done)
  {
    const double seconds = watch.seconds();
    if (n_done <= n_done_before || n_done >= n_total ||
        seconds - last_line < seconds_between_lines)
      return;
    last_line = seconds;

    const double n_left = static_cast<double>(n_total - n_done),
                 n_made = static_cast<double>(n_done - n_done_before);
    log.message(fmt::format("{} {} of {}, about {} left",
                            name_of_one,
                            n_done,
                            n_total,
                            human_seconds(seconds / n_made * n_left)));
  }
} // namespace RollingContact
