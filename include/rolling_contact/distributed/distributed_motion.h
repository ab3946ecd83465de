#ifndef rolling_contact_distributed_distributed_motion_h
#define rolling_contact_distributed_distributed_motion_h

#include <rolling_contact/distributed/distributed_theta_system.h>
#include <rolling_contact/distributed/extrapolated_guess.h>

namespace RollingContact
{
  /**
   * A DistributedBody in time: the scheme of ThetaStepper with solves by
   * conjugate gradients. begin_step() solves for the motion without reactions,
   * response() for what given reactions add. Functions are collective but for
   * remember(), go_back() and what only returns a value.
   */
  template <int dim>
  class DistributedMotion : public BodyDynamics
  {
  public:
    DistributedMotion(const DistributedBody<dim>                  &body,
                      std::shared_ptr<DistributedThetaSystem<dim>> system);

    std::unique_ptr<BodyDynamics>
    clone_state() const override;

    void
    set_time_step(const double h) override;

    const DenseMatrix &
    contact_compliance() const override;

    std::vector<double>
    response(const std::vector<double> &reactions) override;

    void
    set_static_state(const BodyField &displacement) override;

    void
    set_flight_velocity(const double velocity) override;

    void
    accelerate_hub(const double acceleration) override;

    void
    begin_step() override;

    void
    end_step(const std::vector<double> &reactions) override;

    std::vector<double>
    contact_displacement() const override
    {
      return on_contact(u);
    }

    std::vector<double>
    contact_velocity() const override
    {
      return on_contact(v);
    }

    std::vector<double>
    free_contact_displacement() const override;

    std::vector<double>
    free_contact_velocity() const override;

    double
    mean_velocity() override;

    const StepEnergy &
    energy() const override
    {
      return step_energy;
    }

    BodyField
    displacement() const override;

    void
    remember() override;

    void
    go_back() override;

    BodyMotion
    save() const override;

    void
    restore(const BodyMotion &motion) override;

    Memory
    memory_consumption() const override;

    std::string
    description() const override;

  private:
    /**
     * The state that go_back() returns to.
     */
    struct Kept
    {
      DistributedVector u, v, Ku, Mv;
      StepEnergy        energy;
    };

    /**
     * Take a displacement and a velocity as the state. Units: m, m/s.
     */
    void
    set_state(const DistributedVector &displacement,
              const DistributedVector &velocity);

    /**
     * Forget the step that has begun and the guesses for the next one.
     */
    void
    start_anew();

    /**
     * Throws std::logic_error unless a step of the present length has begun.
     */
    void
    require_begun() const;

    /**
     * M e_z by row sums: a consistent mass couples to the hub's own nodes as
     * well. Units: kg.
     */
    const DistributedVector &
    translational_inertia();

    /**
     * Values at the contact nodes, on all ranks.
     */
    std::vector<double>
    on_contact(const DistributedVector &values) const;

    /**
     * Advance u, K u and the energies they take part in from v_th in `work`.
     */
    void
    move_displacement();

    /**
     * Advance v, M v and the energies they take part in from v_th in `work`,
     * which is overwritten.
     */
    void
    change_velocity();

    const DistributedBody<dim>                  &body;
    std::shared_ptr<DistributedThetaSystem<dim>> system;
    DistributedVector                            u, v, Ku, Mv, f, work, z;
    ExtrapolatedGuess                            free_motion, answer;
    DistributedVector   inertia; ///< row sums of M in e_z, or empty; kg
    std::vector<double> answered;
    double              last_acceleration = 0.;
    double              begun_step        = 0.;
    unsigned int        n_steps = 0, n_solves = 0, n_iterations = 0;
    StepEnergy          step_energy;
    Kept                kept;
  };
} // namespace RollingContact

#endif
