#ifndef rolling_contact_tests_unit_plain_stepper_h
#define rolling_contact_tests_unit_plain_stepper_h

#include <rolling_contact/bodies/theta_stepper.h>

namespace RollingContact
{
  /**
   * The steps of unknowns that belong to no mesh.
   */
  class PlainStepper : public ThetaStepper<ThetaSystem>
  {
  public:
    using ThetaStepper<ThetaSystem>::ThetaStepper;

    std::unique_ptr<BodyDynamics> make_twin() override
    {
      auto twin = std::make_unique<PlainStepper>(system);
      step_with(*twin);
      return twin;
    }

    void set_static_state(const BodyField &) override
    {}

    void set_flight_velocity(const double) override
    {}

    void accelerate_hub(const double) override
    {}

    double mean_velocity() override
    {
      return 0.;
    }

    BodyField displacement() const override
    {
      return {};
    }

    BodyMotion save() const override
    {
      return {};
    }

    void restore(const BodyMotion &) override
    {}
  };
} // namespace RollingContact

#endif
