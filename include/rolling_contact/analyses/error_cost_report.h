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
   * What a study found, points in the order of its methods: the plot of error
   * against time of the first set with its Pareto front, error_cpu.svg, and for
   * each set the cheapest method for each error level that is reached, best.csv
   * and on the screen. @p cost says what the time is of, "state".
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
