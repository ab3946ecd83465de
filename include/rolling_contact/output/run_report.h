#ifndef rolling_contact_output_run_report_h
#define rolling_contact_output_run_report_h

#include <rolling_contact/base/phase_timer.h>
#include <rolling_contact/base/run_folder.h>

#include <string>
#include <utility>
#include <vector>

namespace RollingContact
{
  enum class RunStatus
  {
    running,
    done,
    not_converged,
    failed,
    interrupted
  };

  /** Something a run built, or left out, and why. */
  struct BuiltObject
  {
    std::string object;
    bool        built   = true;
    std::size_t bytes   = 0;
    double      seconds = 0.;
    std::string reason;
  };

  /**
   * How far a result is off, largest over the states of the run: against a
   * closed form or another reference, or estimated and how. Units: 1, of @p
   * scale.
   */
  struct ResultError
  {
    std::string quantity; ///< "force"
    double      value = 0.;
    std::string scale;     ///< "mu N"
    std::string reference; ///< "Carter"; of an estimate, what it is based on
    bool        estimated = false;
    std::string remark;

    std::string
    text() const;
  };

  /**
   * What a run was and did, as it stands in run.json. Filled by the driver and
   * the analyses; adds the times, the memory and the CPUs of the host itself,
   * and leaves the list of files to the run folder.
   */
  struct RunReport
  {
    std::string                                      version;
    std::string                                      git_revision;
    std::vector<std::pair<std::string, std::string>> libraries;
    unsigned int                                     n_threads = 1;
    unsigned int                                     n_ranks   = 1;
    std::vector<std::string>                         command_line;
    std::vector<BuiltObject>                         objects;
    std::vector<std::string>                         warnings;
    std::vector<ResultError>                         errors;

    /** Rewrites run.json; to be called at the start, whenever something worth
     * keeping happened, and at the end. */
    void
    write(RunFolder        &folder,
          const RunStatus   status,
          const PhaseTimer &timer) const;

    /** The objects as text for the screen: built, then left out. */
    std::string
    objects_summary() const;

    /** Errors of the results, CPU seconds and where they went, in percent that
     * add up to 100. */
    std::string
    error_line(const PhaseTimer &timer) const;
  };
} // namespace RollingContact

#endif
