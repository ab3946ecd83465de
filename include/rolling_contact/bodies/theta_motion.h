#ifndef rolling_contact_bodies_theta_motion_h
#define rolling_contact_bodies_theta_motion_h

#include <rolling_contact/bodies/theta_stepper.h>

namespace RollingContact
{
  /**
   * A DirectBody or a DistributedBody in time. Functions are collective for a
   * distributed body but for remember(), go_back() and what only returns a
   * value.
   */
  template <typename Body>
  class ThetaMotion : public ThetaStepper<typename Body::StepSystem>
  {
  public:
    using System  = typename Body::StepSystem;
    using Stepper = ThetaStepper<System>;
    using Vector  = typename System::Vector;

    ThetaMotion(const Body &body, std::shared_ptr<System> system)
      : Stepper(std::move(system))
      , body(body)
    {}

    std::unique_ptr<BodyDynamics> make_twin() override
    {
      auto twin = std::make_unique<ThetaMotion>(body, this->system);
      this->step_with(*twin);
      return twin;
    }

    void set_static_state(const BodyField &displacement) override
    {
      this->set_state(body.unknowns_of(displacement), this->system->vector());
    }

    void set_flight_velocity(const double velocity) override
    {
      this->set_state(this->system->vector(), times(velocity, rise()));
    }

    void accelerate_hub(const double acceleration) override
    {
      if (acceleration != last_acceleration)
        this->set_loads(times(-acceleration, inertia()));
      last_acceleration = acceleration;
    }

    double mean_velocity() override
    {
      return System::dot(inertia(), this->velocities()) /
             System::dot(inertia(), rise());
    }

    BodyField displacement() const override
    {
      return body.field(this->displacements());
    }

    BodyMotion save() const override
    {
      return body.in_portable_order(this->displacements(), this->velocities());
    }

    void restore(const BodyMotion &motion) override
    {
      require_size(motion, body.n_unknowns());
      const auto [u, v] = body.from_portable_order(motion);
      this->set_state(u, v);
    }

  private:
    static Vector times(const double factor, Vector x)
    {
      for (double &value : x)
        value *= factor;
      return x;
    }

    /**
     * The rigid motion e_z of all that moves. Units: 1.
     */
    const Vector &rise()
    {
      if (rigid_rise.size() == 0)
        rigid_rise = body.rise();
      return rigid_rise;
    }

    /**
     * M e_z by row sums: a consistent mass couples to the hub's own nodes as
     * well. Units: kg.
     */
    const Vector &inertia()
    {
      if (row_sums.size() == 0)
        row_sums = body.lumped_momentum(rise());
      return row_sums;
    }

    const Body &body;
    Vector      rigid_rise, row_sums; ///< empty until asked for
    double      last_acceleration = 0.;
  };
} // namespace RollingContact

#endif
