#ifndef rolling_contact_elasticity_direct_motion_h
#define rolling_contact_elasticity_direct_motion_h

#include <rolling_contact/dynamics/body_dynamics.h>

#include <optional>

namespace RollingContact
{
  template <int dim>
  class DirectBody;

  /**
   * A DirectBody in time: the step matrix is factorised and condensed, a step
   * is a forward and a backward solve.
   */
  template <int dim>
  class DirectMotion : public BodyDynamics
  {
  public:
    DirectMotion(const DirectBody<dim>       &body,
                 std::shared_ptr<ThetaSystem> system);

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

    void
    begin_step_with(BodyDynamics &other) override;

    void
    end_step_with(BodyDynamics              &other,
                  const std::vector<double> &reactions,
                  const std::vector<double> &reactions_of_other) override;

    std::vector<double>
    contact_displacement() const override;

    std::vector<double>
    contact_velocity() const override;

    std::vector<double>
    free_contact_displacement() const override;

    std::vector<double>
    free_contact_velocity() const override;

    double
    mean_velocity() override;

    const StepEnergy &
    energy() const override;

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

  private:
    const std::vector<std::size_t> &
    order() const;

    /**
     * M e_z by row sums: a consistent mass couples to the hub's own nodes as
     * well. Units: kg.
     */
    const std::vector<double> &
    translational_inertia();

    const DirectBody<dim>           &body;
    std::shared_ptr<ThetaSystem>     system;
    ThetaStepper                     stepper;
    BodyMotion                       kept;
    std::vector<double>              inertia; ///< M e_z, or empty; kg
    double                           last_acceleration = 0.;
    mutable std::vector<std::size_t> portable_dof_order;
  };
} // namespace RollingContact

#endif
