#ifndef rolling_contact_analyses_step_estimate_h
#define rolling_contact_analyses_step_estimate_h

#include <rolling_contact/analyses/force_history.h>
#include <rolling_contact/results/result_error.h>
#include <rolling_contact/time/contact_stepper.h>

#include <cstdint>
#include <optional>

namespace RollingContact
{
  /** Steps that a run needs, for half as many to be compared with. */
  inline constexpr std::uint64_t fewest_steps = 4;

  /**
   * Steps of about twice the length, half as many, the last of which ends when
   * those of @p steps do: of n steps of length h, floor(n/2) of n h /
   * floor(n/2).
   */
  TimeSteps steps_of_twice_the_length(const TimeSteps &steps);

  /**
   * The error that a difference between steps and longer ones tells of,
   *   e = s d / (r - 1),
   * with d the difference, r the ratio of their lengths and s = 4.4 the factor
   * of safety that tests/campaigns/step_errors found: errors are of first order
   * where bodies hit each other. Units: those of @p difference.
   */
  double error_of_steps(const double     difference,
                        const TimeSteps &steps,
                        const TimeSteps &longer);

  /**
   * Estimate of how far the forces that a transient run ends with are off by
   * the length of its time step: the run is repeated from its start with steps
   * of twice the length on the same bodies, and both histories are compared.
   * The largest difference counts, by error_of_steps(), over the load at the
   * end: that of the last tenth of the time, as forces may agree by chance at
   * one instant; with inertia that of all the run, as vibrations which the
   * scheme has damped away by its end in both runs would be there still.
   */
  template <int dim>
  class StepEstimate
  {
  public:
    /**
     * Keep the state that a run starts from, before its first step.
     */
    StepEstimate(const Situation           &scene,
                 const TimeSteps           &steps,
                 const ContactStepper<dim> &stepper,
                 RunContext                &context);

    /**
     * Keep the forces after the run's step of this number, the first being 1.
     */
    void add(const std::uint64_t step, const Resultants &result);

    /**
     * Repeat the run, which has ended, and compare. The stepper is elsewhere
     * afterwards. Nothing, with a warning, if the longer steps fail or the
     * bodies touch in one of the runs only; with a message, if there are less
     * than four steps or a signal ends the repetition. Collective.
     */
    std::optional<StepErrors> errors(ContactStepper<dim> &stepper);

  private:
    /**
     * The end of a history: forces from a step on.
     */
    struct End
    {
      std::uint64_t first = 0; ///< steps that are left out
      ForceHistory  history;
    };

    /**
     * An empty history of steps. Without inertia it leaves out those before the
     * last tenth and @p more; at least @p fewest are kept.
     */
    End end_of(const TimeSteps    &steps,
               const std::uint64_t fewest,
               const std::uint64_t more) const;

    static void
    keep(const std::uint64_t step, const Resultants &result, End &end);

    /**
     * March with the longer steps from the start.
     */
    void repeat(ContactStepper<dim> &stepper);

    std::optional<StepErrors> compared();

    const Situation &scene;
    const TimeSteps  steps, longer;
    RunContext      &context;
    Checkpoint       start;
    End              run, repeated;
  };
} // namespace RollingContact

#endif
