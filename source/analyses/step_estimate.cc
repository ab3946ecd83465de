#include <rolling_contact/analyses/step_estimate.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/time/march.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace RollingContact
{
  TimeSteps steps_of_twice_the_length(const TimeSteps &steps)
  {
    const std::uint64_t number = std::max<std::uint64_t>(1, steps.number / 2);
    return {steps.length * (double(steps.number) / number), number};
  }

  double error_of_steps(const double     difference,
                        const TimeSteps &steps,
                        const TimeSteps &longer)
  {
    const double safety = 4.4; // 99 of 100 random runs are within
    return safety * difference / (longer.length / steps.length - 1);
  }

  namespace
  {
    /**
     * The largest load of a history over the one at its end, 1 without that.
     */
    double largest_over_last_load(const ForceHistory &history)
    {
      const double last    = history.forces.back()[2];
      double       largest = last;
      for (const auto &force : history.forces)
        largest = std::max(largest, force[2]);
      return last > 0. ? largest / last : 1.;
    }
  } // namespace

  template <int dim>
  StepEstimate<dim>::StepEstimate(const Situation           &scene,
                                  const TimeSteps           &steps,
                                  const ContactStepper<dim> &stepper,
                                  RunContext                &context)
    : scene(scene)
    , steps(steps)
    , longer(steps_of_twice_the_length(steps))
    , context(context)
    , run(end_of(steps, 8, 8)) // around the others, for the cubics
    , repeated(end_of(longer, 4, 0))
  {
    stepper.save(start);
  }

  template <int dim>
  typename StepEstimate<dim>::End
  StepEstimate<dim>::end_of(const TimeSteps    &steps,
                            const std::uint64_t fewest,
                            const std::uint64_t more) const
  {
    const TimeParameters &time = scene.inputs->time;
    const std::uint64_t   kept =
      time.inertia
          ? steps.number
          : std::min(steps.number, std::max(steps.number / 10, fewest) + more);
    const double theta = time.inertia ? time.theta : 1.;
    End          end;
    end.first        = steps.number - kept;
    end.history.step = steps.length;
    end.history.lag  = (1 - theta - double(end.first)) * steps.length;
    return end;
  }

  template <int dim>
  void StepEstimate<dim>::keep(const std::uint64_t step,
                               const Resultants   &result,
                               End                &end)
  {
    if (step > end.first)
      end.history.forces.push_back(
        {{result.force_x, result.force_y, result.normal_force}});
  }

  template <int dim>
  void StepEstimate<dim>::add(const std::uint64_t step,
                              const Resultants   &result)
  {
    keep(step, result, run);
  }

  template <int dim>
  void StepEstimate<dim>::repeat(ContactStepper<dim> &stepper)
  {
    const Log::Silence      silence(context.log);
    const PhaseTimer::Scope phase(context.timer, Phase::step_estimate);
    stepper.restore(start);
    TransientProgress progress;
    march<dim>({longer}, stepper, progress, {[&](const StepOutcome &) {
                 keep(progress.step, stepper.current().result, repeated);
               }});
  }

  template <int dim>
  std::optional<StepErrors> StepEstimate<dim>::compared()
  {
    const HistoryErrors found = history_errors(repeated.history, run.history);
    const double        share = largest_over_last_load(run.history),
                 mu           = scene.contact.friction_coefficient;
    const auto error          = [&](const double difference) {
      return error_of_steps(difference * share, steps, longer);
    };
    StepErrors errors;
    errors.load  = error(found.load_largest);
    errors.force = mu > 0. ? error(found.force_largest / mu) : 0.;
    if (std::isfinite(errors.load) && std::isfinite(errors.force))
      return errors;
    context.log.warning(
      "The error of the time step is not known: at the end "
      "the bodies touch with steps of twice the length, but "
      "not in the run itself. Take a smaller Time/Time step.");
    return {};
  }

  template <int dim>
  std::optional<StepErrors>
  StepEstimate<dim>::errors(ContactStepper<dim> &stepper)
  {
    if (steps.number < fewest_steps)
      {
        context.log.message("Time/Step estimate needs a run of at least " +
                            std::to_string(fewest_steps) + " steps.");
        return {};
      }
    context.log.message("The run is repeated with " +
                        std::to_string(longer.number) + " steps of " +
                        significant(longer.length, 4) +
                        " s, to find the error of the time step (Time/Step "
                        "estimate).");
    const auto failed = [&](const std::exception &error) {
      context.log.warning(
        std::string("The error of the time step is not known, "
                    "as steps of twice the length fail: ") +
        error.what());
    };
    try
      {
        repeat(stepper);
        return compared();
      }
    catch (const Interrupted &)
      {
        context.log.message("Interrupted: the run is complete, but the error "
                            "of its time step is not estimated.");
      }
    catch (const ConvergenceError &error)
      {
        failed(error);
      }
    catch (const InputError &error)
      {
        failed(error);
      }
    return {};
  }

  template class StepEstimate<2>;
  template class StepEstimate<3>;
} // namespace RollingContact
