#ifndef rolling_contact_analyses_error_cost_report_h
#define rolling_contact_analyses_error_cost_report_h

#include <rolling_contact/analyses/error_cost.h>
#include <rolling_contact/run/run_context.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Columns of text, aligned to the right but for the first, for the screen;
   * the first row holds the names.
   */
  std::string aligned_table(const std::vector<std::vector<std::string>> &rows);

  /**
   * Points of all that a study solved, or of a part, and what part that is.
   */
  struct ErrorCostSet
  {
    std::string              part; ///< "all", "spin"
    std::vector<CostedError> points;
  };

  /**
   * Report the results of a study, with points in the order of its methods.
   * error_cpu.svg plots error against time for the first set, with its Pareto
   * front. best.csv and the screen show, for each set, the cheapest method for
   * each error level that is reached. @p cost names what the time is for, such
   * as "state".
   */
  void report_errors_and_costs(const std::vector<ErrorCostSet> &sets,
                               const std::string               &error,
                               const std::string               &cost,
                               RunContext                      &context);

  /**
   * Note the smallest error of a study, over @p scale, in the report.
   */
  void note_study_error(const std::vector<CostedError> &points,
                        const std::string              &quantity,
                        const std::string              &scale,
                        const std::string              &reference,
                        RunReport                      &report);
} // namespace RollingContact

#endif
