#ifndef rolling_contact_tables_quiet_context_h
#define rolling_contact_tables_quiet_context_h

#include <rolling_contact/run/run_context.h>

#include <ostream>

namespace RollingContact
{
  /**
   * A RunContext for those who have no run: no folder, no table that is
   * written, a log that nobody reads unless a stream is given.
   */
  class QuietContext
  {
  public:
    explicit QuietContext(std::ostream   *out       = nullptr,
                          const Verbosity verbosity = Verbosity::quiet)
      : nothing(nullptr)
      , folder("", "", "")
      , log(verbosity, out ? *out : nothing, out ? *out : nothing)
      , run{folder, results, report, timer, log}
    {}

    QuietContext(const QuietContext &)            = delete;
    QuietContext &operator=(const QuietContext &) = delete;

  private:
    std::ostream nothing;
    RunFolder    folder;
    ResultsTable results;
    RunReport    report;
    PhaseTimer   timer;
    Log          log;

  public:
    RunContext run;
  };
} // namespace RollingContact

#endif
