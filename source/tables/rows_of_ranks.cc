#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/ranks.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/tables/rows_of_ranks.h>
#include <rolling_contact/tables/table_rows.h>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace RollingContact
{
  RowsOfRanks::RowsOfRanks(RunContext &of_run)
    : of_run(of_run)
    , n_ranks(Ranks::count())
    , own_rows(ResultsTable::of_rank(of_run.folder, Ranks::rank()))
    , of_this_rank{of_run.folder,
                   Ranks::is_root() ? of_run.results : own_rows,
                   of_run.report,
                   of_run.timer,
                   of_run.log,
                   of_run.resume}
  {}

  void RowsOfRanks::claim()
  {
    n_before = of_run.results.n_rows();
    if (n_ranks > 1)
      of_run.folder.claim_for_ranks("results.csv");
  }

  void RowsOfRanks::collect(const TablePlan &plan)
  {
    if (n_ranks == 1)
      return;
    const std::size_t own =
      Ranks::is_root() ? of_run.results.n_rows() - n_before : own_rows.n_rows();
    const double n_solved = Ranks::sum(static_cast<double>(own));
    Ranks::on_root([&]() { take_rows(plan, n_solved); });
    take_warnings();
  }

  void RowsOfRanks::take_rows(const TablePlan &plan, const double n_solved)
  {
    std::vector<std::size_t> shares{of_run.results.n_rows() - n_before};
    add_rows_of_ranks(plan, of_run, shares);
    const auto n_found =
      std::accumulate(shares.begin(), shares.end(), std::size_t(0));
    if (static_cast<double>(n_found) < n_solved)
      throw InputError("Of " + significant(n_solved, 12) +
                       " states that ranks have solved, " +
                       std::to_string(n_found) + " are in \"" +
                       of_run.folder.get_path().string() +
                       "\". Give --output a folder that all machines share.");
    shares.resize(n_ranks, 0);
    fewest = *std::min_element(shares.begin(), shares.end());
    most   = *std::max_element(shares.begin(), shares.end());
  }

  void RowsOfRanks::take_warnings()
  {
    for (unsigned int rank = 1; rank < n_ranks; ++rank)
      {
        std::string text;
        if (Ranks::rank() == rank)
          for (const std::string &warning : of_run.log.warnings())
            text += warning + '\n';
        Ranks::broadcast(text, rank);
        const Log::Again   again(of_run.log); // most are those of the root
        std::istringstream lines(text);
        for (std::string line; Ranks::is_root() && std::getline(lines, line);)
          of_run.log.warning(line);
      }
  }

  std::string RowsOfRanks::shares() const
  {
    if (n_ranks == 1)
      return "";
    return std::to_string(n_ranks) + " ranks, " + std::to_string(fewest) +
           (most == fewest ? "" : " to " + std::to_string(most)) +
           " states each";
  }
} // namespace RollingContact
