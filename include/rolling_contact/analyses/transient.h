#ifndef rolling_contact_analyses_transient_h
#define rolling_contact_analyses_transient_h

#include <rolling_contact/analyses/step_estimate.h>
#include <rolling_contact/results/ill_posed_friction.h>
#include <rolling_contact/results/uniqueness_warning.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/transient_output.h>

#include <optional>

namespace RollingContact
{
  /**
   * Analysis = transient: rolling in time, with inertia (theta-scheme, one
   * forward and one backward solve per body and step) or without (quasi-static
   * rolling). Every Time/Checkpoint interval or seconds, when interrupted and
   * at the end it leaves a checkpoint from which --resume goes on to the same
   * numbers. Then the error of the time step is estimated. Throws
   * ConvergenceError with the last good state kept.
   */
  template <int dim>
  class Transient : public Analysis
  {
  public:
    Transient(const Situation &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void run() override;

  private:
    void describe(const ContactStepper<dim> &stepper,
                  const TimeSteps           &steps) const;

    /**
     * March to the end with rows, fields, checkpoints and the display of the
     * progress.
     */
    void take_steps(const TimeSteps      &steps,
                    ContactStepper<dim>  &stepper,
                    TransientOutput<dim> &output);

    void summarise(const ContactStepper<dim> &stepper) const;

    const Situation                 &scene;
    RunContext                      &context;
    TransientProgress                progress;
    PrmEntries                       files;   ///< fingerprints, for checkpoints
    UniquenessSummary                worst;   ///< of the steps of this run
    std::optional<IllPosedFriction>  falling; ///< the same
    std::optional<StepEstimate<dim>> estimate; ///< none if not to be made
  };

  AnalysisKind transient_kind();
} // namespace RollingContact

#endif
