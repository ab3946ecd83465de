#ifndef rolling_contact_analyses_time_study_h
#define rolling_contact_analyses_time_study_h

#include <rolling_contact/analyses/error_cost.h>
#include <rolling_contact/analyses/force_history.h>
#include <rolling_contact/analyses/study_state.h>
#include <rolling_contact/scene/analysis.h>
#include <rolling_contact/scene/situation.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Analysis = accuracy study with Vary = time step: the transient scene with
   * several steps and thetas on its mesh, against the history that the smallest
   * steps point to. Judged is the force over mu N, without friction the load
   * over N, with N the largest load. A row for each run in summary.csv, then
   * report_errors_and_costs(). A run that fails is marked so; only the
   * reference must end.
   */
  template <int dim>
  class TimeStudy : public Analysis
  {
  public:
    TimeStudy(const Situation &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void run() override;

  private:
    /**
     * One run with all it cost, set-up included.
     */
    struct Run
    {
      double       step  = 0.; ///< s
      double       theta = 0.;
      ForceHistory history;
      double       set_up_s    = 0.; ///< CPU
      double       steps_s     = 0.; ///< CPU
      double       iterations  = 0.; ///< per step
      std::size_t  peak_memory = 0;
      std::string  failure; ///< empty if it ended
    };

    Run solve(const double step, const double theta);

    void take_steps(const Situation &varied, Run &run);

    void
    add_row(const Run &run, const HistoryErrors &errors, ResultsTable &table);

    void report(const std::vector<Run> &runs, const ForceHistory &reference);

    /**
     * The judged error of a run.
     */
    double judged(const HistoryErrors &errors) const;

    const Situation &scene;
    RunContext      &context;
  };
} // namespace RollingContact

#endif
