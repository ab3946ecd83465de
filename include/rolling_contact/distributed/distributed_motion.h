#ifndef rolling_contact_distributed_distributed_motion_h
#define rolling_contact_distributed_distributed_motion_h

#include <rolling_contact/distributed/distributed_theta_system.h>
#include <rolling_contact/distributed/extrapolated_guess.h>

namespace RollingContact
{
  /**
   * A DistributedBody in time, the scheme of ThetaStepper with solves by
   * conjugate gradients: in begin_step() one for the motion without reactions,
   * in response() one for what given reactions add.
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
    contact_displacement() const override;

    std::vector<double>
    contact_velocity() const override;

    std::vector<double>
    free_contact_displacement() const override;

    std::vector<double>
    free_contact_velocity() const override;

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
     * What a failed step goes back to, without asking the other ranks.
     */
    struct Kept
    {
      DistributedVector u, v, Ku, Mv;
      StepEnergy        energy;
    };

    void
    set_state(const DistributedVector &displacement,
              const DistributedVector &velocity);

    /**
     * Forget the step that has begun and what was extrapolated to it.
     */
    void
    start_anew();

    void
    require_begun() const;

    std::vector<double>
    on_contact(const DistributedVector &values) const;

    /**
     * u, K u and their energies at the end of the step from v_th in `work`.
     */
    void
    move_displacement();

    /**
     * v, M v and their energies from v_th in `work`.
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
