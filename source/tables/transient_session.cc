#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/tables/outside_drive.h>
#include <rolling_contact/tables/quiet_context.h>
#include <rolling_contact/tables/transient_session.h>
#include <rolling_contact/time/march.h>

#include <atomic>
#include <cmath>

namespace RollingContact
{
  struct TransientSession::Saved
  {
    std::uint64_t    number_of_session;
    Checkpoint       checkpoint;
    DrivingFunctions histories;
    OutsideDrive     drive;
    TransientState   found;
  };

  /**
   * What does not depend on the dimension.
   */
  class TransientSession::Implementation
  {
  public:
    explicit Implementation(const Situation &scene)
      : scene(scene)
      , number(++n_sessions)
    {}

    virtual ~Implementation() = default;

    virtual void step(const StepInputs   &inputs,
                      const double        length,
                      const BetweenValues between) = 0;

    virtual std::shared_ptr<const Saved> save() const = 0;

    virtual void restore(const Saved &saved) = 0;

    const Situation             scene;
    const std::uint64_t         number;
    double                      scene_step = 0.; ///< s
    TransientState              found;
    const ContactProblem       *problem = nullptr;
    const ContactState         *state   = nullptr;
    std::optional<OutsideDrive> drive;

  private:
    static inline std::atomic<std::uint64_t> n_sessions{0};
  };

  namespace
  {
    template <int dim>
    class Stepping : public TransientSession::Implementation
    {
    public:
      Stepping(const Situation &scene,
               std::ostream    *log,
               const Verbosity  verbosity);

      void step(const StepInputs   &inputs,
                const double        length,
                const BetweenValues between) override;

      std::shared_ptr<const TransientSession::Saved> save() const override;

      void restore(const TransientSession::Saved &saved) override;

    private:
      void take(const StepOutcome &outcome);

      QuietContext        context;
      ContactStepper<dim> stepper;
    };

    template <int dim>
    Stepping<dim>::Stepping(const Situation &given,
                            std::ostream    *log,
                            const Verbosity  verbosity)
      : Implementation(given)
      , context(log, verbosity)
      , stepper(scene, PairDemands(), context.run)
    {
      const SteadyState<dim> &contact = stepper.current();
      problem                         = &contact.problem;
      state                           = &contact.state;
      scene_step      = scene.inputs->time.steps(stepper.drive().speed).length;
      found.forces    = contact.result;
      found.approach  = contact.state.approach;
      found.creepages = contact.problem.loads.creepages;
      found.speed     = stepper.drive().speed.value(0.);
      found.solver    = contact.solver;
      found.solver.converged = true;
      found.wheel_velocity   = stepper.bodies().wheel_velocity();
      drive.emplace(scene, stepper.drive());
      drive->remember(0., stepper.drive(), found.creepages, found.forces);
    }

    template <int dim>
    void Stepping<dim>::step(const StepInputs   &inputs,
                             const double        length,
                             const BetweenValues between)
    {
      const Stopwatch        watch;
      const OutsideDrive     drive_before     = *drive;
      const DrivingFunctions histories_before = stepper.drive();
      const double           time             = found.time;
      try
        {
          stepper.set_drive_functions(
            drive->next(inputs, time, length, between));
          march<dim>({{length, 1}, time},
                     stepper,
                     found.progress,
                     {[&](const StepOutcome &outcome) { take(outcome); }});
        }
      catch (...)
        {
          *drive = drive_before;
          stepper.set_drive_functions(histories_before);
          throw;
        }
      drive->remember(found.time,
                      stepper.drive(),
                      found.creepages,
                      found.forces);
      found.seconds = watch.seconds();
    }

    template <int dim>
    void Stepping<dim>::take(const StepOutcome &outcome)
    {
      const SteadyState<dim> &contact = stepper.current();
      found.time                      = found.progress.time;
      found.force_time                = found.time - outcome.force_lag;
      found.forces                    = contact.result;
      found.approach                  = contact.state.approach;
      found.creepages                 = contact.problem.loads.creepages;
      found.speed                     = outcome.speed;
      found.kinetic_energy            = outcome.energy.kinetic;
      found.strain_energy             = outcome.energy.strain;
      found.n_sticking                = outcome.n_sticking;
      found.n_parts                   = outcome.n_parts;
      found.solver                    = contact.solver;
      found.wheel_velocity            = outcome.wheel_velocity;
    }

    template <int dim>
    std::shared_ptr<const TransientSession::Saved> Stepping<dim>::save() const
    {
      Checkpoint checkpoint;
      stepper.save(checkpoint);
      checkpoint.progress = found.progress;
      return std::make_shared<const TransientSession::Saved>(
        TransientSession::Saved{
          number, std::move(checkpoint), stepper.drive(), *drive, found});
    }

    template <int dim>
    void Stepping<dim>::restore(const TransientSession::Saved &saved)
    {
      if (saved.number_of_session != number)
        throw InputError("This state was saved by another transient session: "
                         "restore what this one saved.");
      stepper.set_drive_functions(saved.histories);
      stepper.restore(saved.checkpoint);
      *drive = saved.drive;
      found  = saved.found;
    }

    void check_scene_in_time(const Situation &scene)
    {
      scene.inputs->check();
      if (!scene.inputs->analysis.records_run)
        throw InputError("Analysis = " + scene.inputs->analysis.name +
                         ": a session in time needs Analysis = transient.");
      if (!bodies_touch(scene))
        throw InputError("Analysis = transient needs a patch to make the mesh "
                         "for: give Contact/Approach or Contact/Normal load "
                         "above 0; the first steps may have another.");
    }
  } // namespace

  TransientSession::TransientSession(const Situation &scene,
                                     std::ostream    *log,
                                     const Verbosity  verbosity)
  {
    check_scene_in_time(scene);
    if (scene.dimension == 2)
      implementation = std::make_unique<Stepping<2>>(scene, log, verbosity);
    else
      implementation = std::make_unique<Stepping<3>>(scene, log, verbosity);
  }

  TransientSession::~TransientSession() = default;

  TransientSession::TransientSession(TransientSession &&) noexcept = default;

  TransientSession &
  TransientSession::operator=(TransientSession &&) noexcept = default;

  const TransientState &
  TransientSession::step(const StepInputs           &inputs,
                         const std::optional<double> length,
                         const BetweenValues         between)
  {
    const double h    = length.value_or(implementation->scene_step),
                 time = implementation->found.time;
    if (!std::isfinite(h) || !(h > 0.) || !(time + 0.5e-6 * h > time))
      throw InputError("The step has " + significant(h, 6) +
                       " s at t = " + significant(time, 6) +
                       " s: its length must be above 0 s, finite and not lost "
                       "in the digits of t.");
    implementation->step(inputs, h, between);
    return implementation->found;
  }

  const TransientState &TransientSession::current() const
  {
    return implementation->found;
  }

  const ContactProblem &TransientSession::problem() const
  {
    return *implementation->problem;
  }

  const ContactState &TransientSession::state() const
  {
    return *implementation->state;
  }

  std::shared_ptr<const TransientSession::Saved> TransientSession::save() const
  {
    return implementation->save();
  }

  void TransientSession::restore(const Saved &saved)
  {
    implementation->restore(saved);
  }
} // namespace RollingContact
