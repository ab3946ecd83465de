#ifndef rolling_contact_run_run_context_h
#define rolling_contact_run_run_context_h

#include <rolling_contact/run/log.h>
#include <rolling_contact/run/phase_timer.h>
#include <rolling_contact/run/results_table.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/run/run_report.h>

namespace RollingContact
{
  /**
   * What a run writes to, logs to and counts its time by; owned by the driver.
   */
  struct RunContext
  {
    RunFolder    &folder;
    ResultsTable &results;
    RunReport    &report;
    PhaseTimer   &timer;
    Log          &log;
    /** Continue from the checkpoint in the folder. */
    bool resume = false;
  };
} // namespace RollingContact

#endif
