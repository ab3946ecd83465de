#ifndef rolling_contact_analyses_impacts_h
#define rolling_contact_analyses_impacts_h

#include <rolling_contact/analyses/impact_report.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/history_rows.h>

#include <string>
#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Impact`: how fast the wheel rolls over what is on the surfaces.
   */
  struct ImpactParameters
  {
    void declare(Entries &entries);

    /** Throws InputError unless speeds are above 0. */
    void check() const;

    /** Ascending; @p given if there are none. Throws InputError. Units: m/s. */
    std::vector<double> speeds_or(const double given) const;

    std::string speeds = "";
  };

  /**
   * Analysis = impact: the largest load and pressure as a wheel runs over a
   * flat, a dip, a joint or whatever is on the surfaces, over speed. Bodies are
   * reduced to their modes once; each speed is a run in time from the steady
   * state before, and a second one with steps of twice the length, for the
   * error. A row of results.csv for each speed.
   */
  template <int dim>
  class Impacts : public Analysis
  {
  public:
    Impacts(const Situation &scene, RunContext &context);

    void run() override;

  private:
    Situation scene_at(const double speed) const;

    /** Pressures on the edges of a flat have no limit. */
    void warn_of_edges() const;

    Impact impact_at(const double speed) const;

    ImpactRun march_over(const TimeSteps     &steps,
                         const HistoryRows   &columns,
                         ContactStepper<dim> &stepper) const;

    /** Repeat a run from its start, for its errors. */
    void estimate(const TimeSteps     &steps,
                  const HistoryRows   &columns,
                  const Checkpoint    &start,
                  ContactStepper<dim> &stepper,
                  Impact              &impact) const;

    const Situation          &scene;
    RunContext               &context;
    const std::vector<double> speeds;
    ReducedBodies<dim>        bodies;
  };

  AnalysisKind impact_kind();
} // namespace RollingContact

#endif
