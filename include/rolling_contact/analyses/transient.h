#ifndef rolling_contact_analyses_transient_h
#define rolling_contact_analyses_transient_h

#include <rolling_contact/analyses/analysis.h>
#include <rolling_contact/assessment/ill_posed_friction.h>
#include <rolling_contact/assessment/uniqueness_warning.h>
#include <rolling_contact/histories/transient_output.h>

#include <optional>

namespace RollingContact
{
  /**
   * Analysis = transient: rolling in time, with inertia (theta-scheme, one
   * forward and one backward solve per body and step) or without (quasi-static
   * rolling). Every Time/Checkpoint interval or seconds, when interrupted and
   * at the end it leaves a checkpoint from which --resume goes on to the same
   * numbers. Throws ConvergenceError with the last good state kept.
   */
  template <int dim>
  class Transient : public Analysis
  {
  public:
    Transient(const SceneParameters &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void
    run() override;

  private:
    void
    describe(const ContactStepper<dim> &stepper, const TimeSteps &steps) const;

    /**
     * Of steps that are too long for the surfaces that move.
     */
    void
    warn_of_long_steps(const ContactStepper<dim> &stepper,
                       const TimeSteps           &steps) const;

    /**
     * Steps until the end.
     */
    void
    march(const TimeSteps      &steps,
          ContactStepper<dim>  &stepper,
          TransientOutput<dim> &output);

    void
    take_step(const TimeSteps      &steps,
              ContactStepper<dim>  &stepper,
              TransientOutput<dim> &output);

    void
    summarise(const ContactStepper<dim> &stepper) const;

    const SceneParameters          &scene;
    RunContext                     &context;
    TransientProgress               progress;
    PrmEntries                      files;   ///< fingerprints, for checkpoints
    UniquenessSummary               worst;   ///< of the steps of this run
    std::optional<IllPosedFriction> falling; ///< the same
  };
} // namespace RollingContact

#endif
