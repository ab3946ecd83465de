#ifndef rolling_contact_time_march_h
#define rolling_contact_time_march_h

#include <rolling_contact/time/contact_stepper.h>

#include <functional>
#include <vector>

namespace RollingContact
{
  /**
   * Called after each step of a march, with what the step did.
   */
  using StepObserver = std::function<void(const StepOutcome &)>;

  /**
   * The steps of a march. Units: s.
   */
  struct MarchedSteps
  {
    TimeSteps     steps;      ///< all of them
    double        begin = 0.; ///< time before the first one
    std::uint64_t done  = 0;  ///< steps that a run before has taken
    /** True if the march may end before its last step; empty for never. */
    std::function<bool()> settled = {};
  };

  /**
   * Take steps of one length, add each to @p progress and call the observers
   * in their order. Throws Interrupted between two steps and what
   * ContactStepper::advance() throws; stepper and progress are then those after
   * the last good step.
   */
  template <int dim>
  void march(const MarchedSteps              &marched,
             ContactStepper<dim>             &stepper,
             TransientProgress               &progress,
             const std::vector<StepObserver> &observers);
} // namespace RollingContact

#endif
