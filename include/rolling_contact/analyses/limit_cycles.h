#ifndef rolling_contact_analyses_limit_cycles_h
#define rolling_contact_analyses_limit_cycles_h

#include <rolling_contact/analyses/cycle_sweep.h>
#include <rolling_contact/analyses/limit_cycle_parameters.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/contact_stepper.h>
#include <rolling_contact/time/cycle_watch.h>
#include <rolling_contact/vibration/vibrations.h>

namespace RollingContact
{
  /**
   * Analysis = limit cycle: runs in time on bodies that are reduced once, from
   * several vibrations that grow, until each motion repeats itself; and the
   * cycles followed along an axis, each value from the cycle of the one before
   * about its own steady state. A row of results.csv for each run; a run that
   * was stopped goes on behind the last row.
   */
  template <int dim>
  class LimitCycles : public Analysis
  {
  public:
    LimitCycles(const Situation &scene, RunContext &context);

    void run() override;

  private:
    /** The vibrations about the steady state of a scene that grow. */
    struct Growing
    {
      std::vector<double> frequencies;  ///< Hz, by growth
      double              largest = 0.; ///< growth, of all vibrations, 1/s
    };

    Situation scene_at(const std::optional<double> &value) const;

    Growing growing(const Situation &scene) const;

    /** Frequencies of the starts at the first value where a vibration grows. */
    std::vector<double> find_starts() const;

    void restore_rows();

    /** One run, and its row. */
    void take(const SweepRun &run);

    /** Steps until the motion settles or the end; false if one does not
     * converge. */
    bool settle(const Situation     &scene,
                ContactStepper<dim> &stepper,
                CycleWatch          &watch) const;

    const Situation                   &scene;
    const LimitCycleParameters        &section;
    RunContext                        &context;
    ReducedBodies<dim>                 bodies;
    std::unique_ptr<RollingModes<dim>> modes;
    SweepState                         state;
  };

  AnalysisKind limit_cycle_kind();
} // namespace RollingContact

#endif
