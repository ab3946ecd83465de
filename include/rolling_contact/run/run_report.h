#ifndef rolling_contact_run_run_report_h
#define rolling_contact_run_run_report_h

#include <rolling_contact/run/phase_timer.h>
#include <rolling_contact/run/run_folder.h>

#include <optional>
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
  struct BuiltItem
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
  struct ErrorStatement
  {
    std::string quantity; ///< "force"
    double      value = 0.;
    std::string scale;     ///< "mu N"
    std::string reference; ///< "Carter"; of an estimate, what it is based on
    bool        estimated = false;
    std::string remark;
    /** What the length of the time step adds to the value, if known. */
    std::optional<double> time_step = {};

    std::string text() const;
  };

  /**
   * Totals of all MPI ranks together, and of the one that has most.
   */
  struct RankTotals
  {
    double cpu_seconds         = 0.;
    double largest_cpu_seconds = 0.;
    double peak_memory         = 0.; ///< bytes
    double largest_peak_memory = 0.; ///< bytes
  };

  /**
   * Totals of the ranks so far. Collective.
   */
  RankTotals totals_of_ranks(const PhaseTimer &timer);

  /**
   * What a run was and did, as it stands in run.json. Filled by the driver and
   * the analyses; adds the times, the memory and the CPUs of the host itself,
   * and leaves the list of files to the run folder. Times and memory are those
   * of the root, but for the totals.
   */
  struct RunReport
  {
    std::string                                      version;
    std::string                                      git_revision;
    std::vector<std::pair<std::string, std::string>> libraries;
    unsigned int                                     n_threads = 1;
    unsigned int                                     n_ranks   = 1;
    /**
     * Totals of several ranks, once all are done.
     */
    std::optional<RankTotals>   rank_totals;
    std::vector<std::string>    command_line;
    std::vector<BuiltItem>      objects;
    std::vector<std::string>    warnings;
    std::string                 failure; ///< why the run failed, if it did
    std::vector<ErrorStatement> errors;
    /** What the run found, for the summary: "load", "N = ..."; in order. */
    std::vector<std::pair<std::string, std::string>> findings;

    /** Rewrites run.json; to be called at the start, whenever something worth
     * keeping happened, and at the end. */
    void write(RunFolder        &folder,
               const RunStatus   status,
               const PhaseTimer &timer) const;

    /** Adds a finding, in place of an earlier one with this label. */
    void set_finding(const std::string &label, const std::string &text);

    /** The objects as text for the screen: built, then left out. */
    std::string objects_summary() const;

    /**
     * What a user wants first, as lines for the screen: the findings, errors,
     * seconds and where they went in percent that add up to 100, files.
     */
    std::string summary(const PhaseTimer  &timer,
                        const std::string &folder) const;

  private:
    /** Members of run.json, without the braces around them. */
    std::string members(const RunStatus status, const PhaseTimer &timer) const;

    std::string all_errors() const;

    /** "3.1 s, 120 MB; 2.9 s CPU: ..."; with the totals of the ranks if
     * known. */
    std::string cost(const PhaseTimer &timer) const;
  };
} // namespace RollingContact

#endif
