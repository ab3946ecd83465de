#ifndef rolling_contact_tests_campaigns_trial_h
#define rolling_contact_tests_campaigns_trial_h

#include <map>
#include <string>
#include <vector>

/**
 * One run of the program in its own process, with limits, and what it left.
 */
struct Trial
{
  enum class End
  {
    exited,
    crashed, ///< by a signal
    hung     ///< beyond the limit of CPU or wall time
  };

  using Row = std::map<std::string, std::string>;

  End              end       = End::exited;
  int              exit_code = -1;
  double           cpu_s     = 0.;
  std::string      messages; ///< standard error
  std::vector<Row> rows;     ///< of results.csv, or of history.csv

  /**
   * A cell of the last row as a number; 0 where there is none.
   */
  double number(const std::string &column) const;

  std::string cell(const std::string &column) const;

  /**
   * Largest cell of a column.
   */
  double largest(const std::string &column) const;

  /**
   * Largest `invariant_*` of all rows and its name.
   */
  std::pair<double, std::string> worst_invariant() const;

  /**
   * What is wrong with a run that should have ended well: crash, hang, exit
   * code, a cell that is not finite, a broken invariant. Empty if nothing.
   */
  std::string complaint() const;
};

struct TrialLimits
{
  unsigned int cpu_s  = 60;
  unsigned int wall_s = 300;
};

/**
 * Run @p program with @p arguments and `--output folder`.
 */
Trial run_trial(const std::string              &program,
                const std::vector<std::string> &arguments,
                const std::string              &folder,
                const TrialLimits              &limits);

/**
 * A new folder to work in, where the system keeps its temporary files.
 */
std::string make_work_folder();

/**
 * Two decimals and the like, for tables.
 */
std::string short_number(const double value);

#endif
