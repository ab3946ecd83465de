#ifndef rolling_contact_analyses_impacts_h
#define rolling_contact_analyses_impacts_h

#include <rolling_contact/analyses/impact_parameters.h>
#include <rolling_contact/analyses/impact_report.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/contact_stepper.h>

namespace RollingContact
{
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

    /** The steps of a run. */
    std::vector<ImpactStep> march_over(const TimeSteps     &steps,
                                       ContactStepper<dim> &stepper) const;

    /** Repeat a run from its start, for its errors. */
    void estimate(const TimeSteps     &steps,
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
