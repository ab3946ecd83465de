#ifndef rolling_contact_time_history_plot_h
#define rolling_contact_time_history_plot_h

namespace RollingContact
{
  class HistoryTable;
  struct RunContext;
  struct Situation;

  /**
   * history.svg: T/(mu N) and N over the rolled distance, over time if nothing
   * rolls or slips, and below them what drives: heights of moving surfaces,
   * creepages and spin other than zero, the given load, approach and speed
   * where they change.
   */
  void plot_history(const Situation    &scene,
                    const HistoryTable &history,
                    RunContext         &context);
} // namespace RollingContact

#endif
