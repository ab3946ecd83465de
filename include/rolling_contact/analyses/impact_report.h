#ifndef rolling_contact_analyses_impact_report_h
#define rolling_contact_analyses_impact_report_h

#include <rolling_contact/run/run_context.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * The contact in a step of a run over what is on the surfaces. Units: SI.
   */
  struct ImpactStep
  {
    double time     = 0.; ///< when the forces act
    double rolled   = 0.; ///< since t = 0, at the end of the step
    double load     = 0.;
    double pressure = 0.; ///< largest
  };

  /**
   * The steps of a run, and their rows as in history.csv.
   */
  struct ImpactRun
  {
    std::vector<ImpactStep>          steps;
    std::vector<std::vector<double>> rows;
  };

  /**
   * What a run has at the most and at the least.
   */
  struct ImpactExtremes
  {
    explicit ImpactExtremes(const std::vector<ImpactStep> &steps);

    ImpactStep largest_load, largest_pressure, least_load;
    double     parted = 0.; ///< time without contact, s
  };

  /**
   * A run at one speed.
   */
  struct Impact
  {
    double        speed   = 0.;
    double        step    = 0.; ///< length, s
    std::uint64_t n_steps = 0;
    ImpactStep    at_rest; ///< the steady state that the run starts from

    ImpactRun run;

    /** What the length of the steps may have put the largest load and pressure
     * off by; unknown if longer steps failed. Units: N, Pa. */
    std::optional<double> load_error, pressure_error;

    ImpactExtremes extremes() const
    {
      return ImpactExtremes(run.steps);
    }

    double load_ratio() const
    {
      return extremes().largest_load.load / at_rest.load;
    }
  };

  /** The row of a run. */
  void add_row(const Impact &impact, ResultsTable &table);

  /** The run with the largest load over that at rest. */
  const Impact &worst_of(const std::vector<Impact> &impacts);

  /** Findings: the largest load, from which speed on the wheel leaves the rail,
   * and the errors of all. */
  void note_impacts(const std::vector<Impact> &impacts, RunContext &context);

  /** impact_history.csv: the steps of one run, in the columns of its rows. */
  void write_history(const Impact                   &impact,
                     const std::vector<std::string> &columns,
                     RunContext                     &context);

  /** impacts.svg: the largest load and pressure over those at rest, over speed,
   * and the load of the worst run over the distance rolled. */
  void plot_impacts(const std::vector<Impact> &impacts, RunContext &context);
} // namespace RollingContact

#endif
