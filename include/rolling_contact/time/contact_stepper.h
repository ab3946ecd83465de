#ifndef rolling_contact_time_contact_stepper_h
#define rolling_contact_time_contact_stepper_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/contact/uniqueness.h>
#include <rolling_contact/pair/pair_integrator.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/scene/travelled_distance.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/time/checkpoint.h>
#include <rolling_contact/time/initial_contact.h>
#include <rolling_contact/time/patch_friction.h>

#include <memory>
#include <optional>

namespace RollingContact
{
  /**
   * What a time step did. Energies are those of StepEnergy, summed over parts
   * if the step was halved; friction is what sliding turned into heat, and
   * surface_work what of the contact's work heights that move supplied: nodal
   * forces times how much the heights at the nodes grew. Units: J, m/s.
   */
  struct StepOutcome
  {
    SolverReport solver;
    StepEnergy   energy;
    double       friction       = 0.;
    double       surface_work   = 0.;
    double       surface_height = 0.; ///< m, at the origin when forces act
    double       speed          = 0.;
    double       force_lag  = 0.; ///< s: the forces act before the end by that
    unsigned int n_impacts  = 0;  ///< nodes that closed
    unsigned int n_sticking = 0;
    unsigned int n_parts    = 0; ///< 1 unless halved
    Uniqueness   several;        ///< the worst of the parts
    /** At the end, of the centre of mass of a free wheel along z; m/s. */
    std::optional<double> wheel_velocity;
    /**
     * Velocity of the wheel over the rail at the contact without the rigid
     * creepage, the mean over the nodes weighted with their load: x, y, z.
     * Units: m/s.
     */
    std::array<double, 3> contact_velocity{};
    /**
     * Mean velocities over the step of the watched points, in the order of
     * WatchedPoints. Units: m/s.
     */
    std::vector<double> point_velocity;
    double              friction_share = 1.; ///< m of PatchFriction
  };

  /**
   * Wheel and rail in time: the motion of the bodies, the contact laws of
   * eq. (12) of Lai et al. 2017 at the end of each step, and the histories that
   * drive them. The gap is that of the shifted configuration or the gap plus
   * step times velocity, see PairIntegrator.
   */
  template <int dim>
  class ContactStepper
  {
  public:
    /**
     * Set up mesh, matrices and the initial state. Throws InputError,
     * ConvergenceError.
     */
    ContactStepper(const Situation   &scene,
                   const PairDemands &demands,
                   RunContext        &context);

    /**
     * Go on from a state on bodies that are there.
     */
    ContactStepper(const Situation    &scene,
                   InitialContact<dim> initial,
                   RunContext         &context);

    /**
     * Factorise and condense for this step, if it is not the current one.
     * Units: s.
     */
    void set_time_step(const double h);

    /**
     * Step from @p time by @p h; when the contact solve fails, in 2, 4, ...
     * parts up to 2^`Time/Maximum halvings`. Throws ConvergenceError, leaving
     * the last good state, when that fails too, when the patch reaches the
     * border of the candidate zone, an energy is not a number or an invariant
     * of the contact is broken. Units: s.
     */
    StepOutcome advance(const double time, const double h);

    /**
     * The vibrations of the state that the run starts from by their
     * eigenvalues, as StabilityPencil::eigenvalues(), where one is excited or
     * the scene wants spectra and has them; else empty. Units: 1/s.
     */
    const ComplexValues &eigenvalues() const
    {
      return vibrations;
    }

    /**
     * The contact now, with the bodies' pair; forces in `result`.
     */
    const SteadyState<dim> &current() const
    {
      return contact;
    }

    const PairIntegrator<dim> &bodies() const
    {
      return *motion;
    }

    const DrivingFunctions &drive() const
    {
      return histories;
    }

    /**
     * Drive the steps from now on by other histories than the scene's, as under
     * control from outside. A load or an approach is given as before, and with
     * surfaces that move the speed stays. The past of an approach down to two
     * steps ago counts, for the acceleration of the hub, and what it will be up
     * to half a step beyond the end.
     */
    void set_drive_functions(const DrivingFunctions &driving);

    /**
     * The eigenvalue of the vibration that the run begins in, if it does so.
     * Units: 1/s.
     */
    const std::optional<std::complex<double>> &excited() const
    {
      return excitation;
    }

    /**
     * How the state differs from the steady one of the start, of reduced
     * bodies.
     */
    Disturbance disturbance() const;

    /**
     * The modes of reduced bodies; nullptr for others.
     */
    const ModalBodies<dim> *modes() const
    {
      return modal.get();
    }

    void save(Checkpoint &checkpoint) const;

    /**
     * Take the state of a checkpoint, under what drove it.
     */
    void restore(const Checkpoint &checkpoint);

  private:
    void set_drive(const double time, const double h);

    /**
     * mu of the nodes, and that of the points that arrive at them, at the end
     * of a step. Units: s.
     */
    void set_friction(const double time, const double h);

    /**
     * Heights at the nodes of surfaces that move; empty if none does. Units: s,
     * m.
     */
    std::vector<double> heights(const double time) const;

    /**
     * See StepOutcome::surface_work, of a part of a step that has ended.
     */
    double surface_work(const ContactState &previous,
                        const double        time,
                        const double        h) const;

    void apply_free_motion(const FreeMotion &free, const double speed);

    /**
     * Solve the contact laws of a part of a step, with the creepages that have
     * the forces asked for; @p speed at its end. Units: m/s.
     */
    void solve(const double speed);

    void solve_given_creepages(const double speed);

    /**
     * Heat of friction in a part of a step that has ended; @p smooth as in
     * PairIntegrator::begin_step(). Units: s, m/s, J.
     */
    double friction_heat(const double h, const double speed, const bool smooth);

    /**
     * True if forces that are asked for jumped in the step before, and the
     * displacements of the surfaces with them: what these did then tells
     * nothing of what they will do. Units: s.
     */
    bool follows_jump(const double time, const double h) const;

    /**
     * Take one part of a step; false, with the state as before, if the solver
     * fails.
     */
    bool take_part(const double time, const double h, StepOutcome &outcome);

    void take_in_parts(const double       time,
                       const double       h,
                       const unsigned int n_halvings,
                       StepOutcome       &outcome);

    StepOutcome take_whole_step(const double time, const double h);

    /**
     * Without the drive of the last step.
     */
    void restore_state(const Checkpoint &checkpoint, const bool slip_is_known);

    /**
     * Theta of the scheme, 1 without inertia: at theta of a step its reactions
     * act.
     */
    double theta() const
    {
      return scene.inputs->time.inertia ? scene.inputs->time.theta : 1.;
    }

    /**
     * When the laws of contact hold in a step, but for the gap. Units: s.
     */
    double time_of_laws(const double time, const double h) const
    {
      return time + (motion->laws_in_the_middle() ? theta() : 1.) * h;
    }

    /**
     * See StepOutcome::contact_velocity.
     */
    std::array<double, 3> contact_velocity() const;

    void finish_part(const ContactState &previous,
                     const double        time,
                     const double        h,
                     const bool          smooth,
                     StepOutcome        &outcome);

    const Situation                     &scene;
    RunContext                          &context;
    DrivingFunctions                     histories;
    const TravelledDistance              travelled;
    SteadyState<dim>                     contact;
    std::unique_ptr<PairIntegrator<dim>> motion;
    std::unique_ptr<ContactSolver>       solver;
    SlipMemory                           slip; ///< at the end of the last step
    std::optional<PatchFriction>         patch_friction;
    std::shared_ptr<const ModalBodies<dim>> modal;
    Disturbance                             undisturbed;
    std::optional<std::complex<double>>     excitation;
    std::vector<double>                     undeformed_gap; ///< smooth surfaces
    std::vector<double>                     step_heights;   ///< on them
    std::vector<bool>                       border;
    ComplexValues                           vibrations;       ///< 1/s
    std::vector<double>                     watched_position; ///< now, m
    double                                  time_step = 0.;
  };
} // namespace RollingContact

#endif
