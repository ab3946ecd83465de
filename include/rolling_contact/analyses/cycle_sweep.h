#ifndef rolling_contact_analyses_cycle_sweep_h
#define rolling_contact_analyses_cycle_sweep_h

#include <rolling_contact/analyses/limit_cycle_parameters.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/time/initial_contact.h>
#include <rolling_contact/time/verdict.h>

#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What a run has come to, as column cycle has it; nothing if one of its steps
   * did not converge.
   */
  using RunEnd = std::optional<Cycles::Motion>;

  std::string name_of(const RunEnd &end);

  /**
   * The end with this name.
   */
  RunEnd end_named(const std::string &name);

  /**
   * The end of the run of a row.
   */
  RunEnd end_of_row(const ResultsTable &results, const std::size_t row);

  /**
   * A run of Analysis = limit cycle.
   */
  struct SweepRun
  {
    std::size_t           start = 0; ///< which of the starts
    std::optional<double> value;     ///< of the axis
    bool                  up    = true;
    bool                  first = true; ///< of its start: nothing to go on from
  };

  /**
   * The runs from so many starts, in their order: for each start all values
   * from the least to the largest, or the other way, or there and back.
   */
  std::vector<SweepRun> sweep_runs(const LimitCycleParameters &parameters,
                                   const std::size_t           n_starts);

  /**
   * What a run hands on to the next, and what is needed to go on after a stop:
   * written behind each row of results.csv.
   */
  struct SweepState
  {
    std::size_t                n_rows = 0; ///< that are done
    std::vector<double>        starts;     ///< frequencies, Hz
    std::optional<Disturbance> carried;    ///< nothing after what has decayed
  };

  /**
   * limit_cycle_state.txt, with all digits.
   */
  void write_sweep_state(const SweepState &state, RunFolder &folder);

  /**
   * Throws InputError naming the file if it is none.
   */
  SweepState read_sweep_state(const RunFolder &folder);

  /**
   * limit_cycles.svg: the amplitude over the axis, up and down, from each
   * start, and below it the growth of the vibration that grows fastest.
   */
  void plot_sweep(const LimitCycleParameters  &parameters,
                  const std::vector<SweepRun> &runs,
                  RunContext                  &context);

  /**
   * Findings: how many runs came to what, whether starts end in the same cycle,
   * whether up and down differ.
   */
  void note_sweep(const LimitCycleParameters  &parameters,
                  const std::vector<SweepRun> &runs,
                  const std::vector<double>   &starts,
                  RunContext                  &context);
} // namespace RollingContact

#endif
