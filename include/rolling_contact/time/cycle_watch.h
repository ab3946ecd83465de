#ifndef rolling_contact_time_cycle_watch_h
#define rolling_contact_time_cycle_watch_h

#include <rolling_contact/run/history_table.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/verdict.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Looks at the rows of a history, with all their digits, for a motion that
   * repeats itself: velocities of the contact and its forces. A run that is
   * stopped and resumed comes to the same verdicts at the same rows.
   */
  class CycleWatch
  {
  public:
    /** Rows follow each other by @p step (s). */
    CycleWatch(const Situation &scene, const double step);

    /** Add a row of history.csv with these columns. */
    void add_row(const std::vector<std::string> &names,
                 const std::vector<double>      &row);

    /** Begin with the rows of a history that is continued. */
    void restore(const HistoryTable &history);

    std::size_t n_rows() const;

    /**
     * Whether a verdict is due after this row (Cycles::is_due()) and says that
     * nothing new is to be expected.
     */
    bool settled();

    /** What the rows so far have come to. */
    const Cycles::Verdict &verdict();

    /** A column of the history; empty if it has none of this name. */
    const std::vector<double> &column(const std::string &name) const
    {
      return columns.at(name);
    }

    double time_step() const
    {
      return step;
    }

    /** Its size. Units: m/s. */
    double rolling_speed() const
    {
      return speed;
    }

  private:
    Cycles::SampledMotion motion() const;

    const double      step, tolerance, speed;
    const std::size_t left_out; ///< rows at the start
    HistoryColumns    columns;
    Cycles::Verdict   last;
    std::size_t       judged = 0; ///< rows that it is of
  };
} // namespace RollingContact

#endif
