#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/tables/table_output.h>

#include <algorithm>

namespace RollingContact
{
  TableSummary summary_of(const ResultsTable &results)
  {
    TableSummary summary;
    for (std::size_t row = 0; row < results.n_rows(); ++row)
      {
        const TableStatus status = status_of_row(results, row);
        summary.states[status].push_back(state_of_row(results, row));
        if (status != TableStatus::solved)
          continue;
        const auto  bound     = results.number(row, "bound_force/muN");
        const auto *solved_by = results.value<SolvedBy>(row, "solver");
        summary.n_without_bound +=
          !bound && !results.number(row, "bound_max_pressure");
        summary.n_fallbacks += solved_by && solved_by->stood_in;
        if (bound)
          summary.largest_bound =
            std::max(summary.largest_bound.value_or(0.), *bound);
      }
    return summary;
  }

  void TableSummary::note(RunReport &report) const
  {
    if (!largest_bound)
      return;
    ErrorStatement error;
    error.quantity  = "force";
    error.value     = *largest_bound;
    error.scale     = "mu N";
    error.reference = "the largest of column bound_force/muN";
    error.estimated = true;
    report.errors.push_back(error);
  }

  void TableSummary::warn(const TablePlan &, Log &log) const
  {
    const auto number = [](const std::size_t n) {
      return n == 1 ? std::string("1 state") : std::to_string(n) + " states";
    };
    if (n_fallbacks > 0)
      log.warning("In " + number(n_fallbacks) +
                  " the edges of contact did not settle or another solver "
                  "took over: the laws of contact hold, but the force may "
                  "have a larger error than elsewhere (column solver of "
                  "results.csv).");
    if (n_without_bound > 0 && largest_bound)
      log.warning("No bound of the error is known for " +
                  number(n_without_bound) +
                  " (column bound_force/muN of results.csv is empty).");
  }

  void TableSummary::require_solved(const TablePlan &plan) const
  {
    std::string text;
    std::size_t n = 0;
    for (const auto &[status, which] : states)
      if (status != TableStatus::solved && status != TableStatus::no_contact)
        {
          n += which.size();
          text += (text.empty() ? "" : "; ") + std::to_string(which.size()) +
                  " x " + name_of(status) + ", first state " +
                  std::to_string(which[0]) + " (" + plan.name(which[0]) + ")";
        }
    if (n > 0)
      throw ConvergenceError(
        "Of " + std::to_string(plan.values.size()) + " states of the table " +
        std::to_string(n) + (n == 1 ? " is" : " are") +
        " not solved (column status of results.csv): " + text + ".");
  }
} // namespace RollingContact
