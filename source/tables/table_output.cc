#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/files.h>
#include <rolling_contact/tables/chain_solver.h>
#include <rolling_contact/tables/table_output.h>

#include <algorithm>
#include <cstdlib>

namespace RollingContact
{
  void
  restore_rows(const TablePlan &plan, RunContext &context)
  {
    const std::string file =
      (context.folder.get_path() / "results.csv").string();
    context.results.restore(read_bytes(file), file);
    std::vector<bool> has_row(plan.values.size(), false);
    for (std::size_t row = 0; row < context.results.n_rows(); ++row)
      {
        const std::string text  = context.results.text(row, "state");
        char             *end   = nullptr;
        const std::size_t state = std::strtoul(text.c_str(), &end, 10);
        bool same = !text.empty() && *end == '\0' && state < has_row.size() &&
                    !has_row[state];
        for (std::size_t d = 0; same && d < plan.entries.size(); ++d)
          same = context.results.text(row, plan.entries[d]) ==
                 exact_text(plan.values[state][d]);
        if (!same)
          throw InputError(
            "Cannot resume the table in \"" +
            context.folder.get_path().string() + "\": row " +
            std::to_string(row + 1) +
            " of results.csv is none of its states; was a file changed? Start "
            "it without --resume.");
        has_row[state] = true;
      }
  }



  std::vector<std::size_t>
  states_with_rows(const ResultsTable &results)
  {
    std::vector<std::size_t> states;
    for (std::size_t row = 0; row < results.n_rows(); ++row)
      states.push_back(std::stoul(results.text(row, "state")));
    return states;
  }



  TableSummary
  summary_of(const ResultsTable &results)
  {
    TableSummary summary;
    for (std::size_t row = 0; row < results.n_rows(); ++row)
      {
        const std::string status = results.text(row, "status");
        summary.states[status].push_back(
          std::stoul(results.text(row, "state")));
        if (status != TableStatus::solved)
          continue;
        const std::string bound  = results.text(row, "bound_force/muN"),
                          solver = results.text(row, "solver");
        summary.n_without_bound +=
          bound.empty() && results.text(row, "bound_max_pressure").empty();
        summary.n_fallbacks += solver.find(", ") != std::string::npos;
        if (!bound.empty())
          summary.largest_bound =
            std::max(summary.largest_bound.value_or(0.), std::stod(bound));
      }
    return summary;
  }



  void
  TableSummary::note(RunReport &report) const
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



  void
  TableSummary::warn(const TablePlan &, Log &log) const
  {
    const auto number = [](const std::size_t n) {
      return n == 1 ? std::string("1 state") : std::to_string(n) + " states";
    };
    if (n_fallbacks > 0)
      log.warning("Of " + number(n_fallbacks) +
                  " the edges did not settle or another solver stood in: the "
                  "laws hold, but the force may be off by more than it is "
                  "elsewhere (column solver of results.csv).");
    if (n_without_bound > 0 && largest_bound)
      log.warning("No bound of the error is known for " +
                  number(n_without_bound) +
                  " (column bound_force/muN of results.csv is empty).");
  }



  void
  TableSummary::require_solved(const TablePlan &plan) const
  {
    std::string text;
    std::size_t n = 0;
    for (const auto &[status, which] : states)
      if (status != TableStatus::solved && status != TableStatus::no_contact)
        {
          n += which.size();
          text += (text.empty() ? "" : "; ") + std::to_string(which.size()) +
                  " x " + status + ", first state " + std::to_string(which[0]) +
                  " (" + plan.name(which[0]) + ")";
        }
    if (n > 0)
      throw ConvergenceError(
        "Of " + std::to_string(plan.values.size()) + " states of the table " +
        std::to_string(n) + (n == 1 ? " is" : " are") +
        " not solved (column status of results.csv): " + text + ".");
  }
} // namespace RollingContact
