#ifndef rolling_contact_histories_history_plot_h
#define rolling_contact_histories_history_plot_h

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace RollingContact
{
  struct RunContext;
  struct SceneParameters;

  /** Values over the rows of history.csv by the name of the column. */
  using HistoryColumns = std::map<std::string, std::vector<double>>;

  /**
   * Some columns of a history.csv, as many rows as there are.
   */
  HistoryColumns
  read_history(const std::filesystem::path    &file,
               const std::vector<std::string> &columns);

  /**
   * history.svg: T/(mu N) and N over the rolled distance, over time if nothing
   * rolls or slips, and below them what drives: heights of moving surfaces,
   * creepages and spin other than zero, the given load, approach and speed
   * where they change. From @p file, history.csv.
   */
  void
  plot_history(const SceneParameters       &scene,
               const std::filesystem::path &file,
               RunContext                  &context);
} // namespace RollingContact

#endif
