#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/time/march.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    /**
     * Add a step of length @p h to what a run has summed up; its time is not.
     * Units: s.
     */
    void add_step(TransientProgress &progress,
                  const StepOutcome &outcome,
                  const double       h)
    {
      const StepEnergy &energy = outcome.energy;
      ++progress.step;
      progress.time_step = h;
      progress.rolled_distance += std::abs(outcome.speed) * h;
      progress.supplied_energy +=
        energy.contact_work + energy.load_work + outcome.friction;
      progress.friction_energy += outcome.friction;
      progress.damping_energy += energy.damping;
      progress.numerical_energy += energy.numerical_dissipation;
      progress.energy_error += energy.balance_error;
      progress.surface_energy += outcome.surface_work;
      progress.n_impacts += outcome.n_impacts;
    }
  } // namespace

  template <int dim>
  void march(const MarchedSteps              &marched,
             ContactStepper<dim>             &stepper,
             TransientProgress               &progress,
             const std::vector<StepObserver> &observers)
  {
    const double h = marched.steps.length;
    for (std::uint64_t k = marched.done; k < marched.steps.number; ++k)
      {
        if (marched.settled && marched.settled())
          return;
        throw_if_interrupted();
        const StepOutcome outcome = stepper.advance(marched.begin + k * h, h);
        add_step(progress, outcome, h);
        progress.time = marched.begin + (k + 1) * h;
        for (const StepObserver &observe : observers)
          observe(outcome);
      }
  }

  template void march(const MarchedSteps &,
                      ContactStepper<2> &,
                      TransientProgress &,
                      const std::vector<StepObserver> &);
  template void march(const MarchedSteps &,
                      ContactStepper<3> &,
                      TransientProgress &,
                      const std::vector<StepObserver> &);
} // namespace RollingContact
