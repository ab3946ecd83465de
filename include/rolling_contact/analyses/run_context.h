#ifndef rolling_contact_analyses_run_context_h
#define rolling_contact_analyses_run_context_h

#include <rolling_contact/base/log.h>
#include <rolling_contact/base/phase_timer.h>
#include <rolling_contact/base/run_folder.h>
#include <rolling_contact/output/results_table.h>
#include <rolling_contact/output/run_report.h>

namespace RollingContact
{
  /**
   * Where a run writes, logs and counts its time; owned by the driver.
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
