#ifndef rolling_contact_vibration_reduced_rolling_h
#define rolling_contact_vibration_reduced_rolling_h

#include <rolling_contact/pair/pair_integrator.h>
#include <rolling_contact/vibration/reduced_motion.h>
#include <rolling_contact/vibration/rolling_modes.h>

namespace RollingContact
{
  /**
   * Wheel and rail in time by their modes, see ReducedMotion. It begins with
   * start_from(), in a steady state or in a vibration about it.
   */
  template <int dim>
  class ReducedRolling : public PairIntegrator<dim>
  {
  public:
    /**
     * Keeps a reference to the pair, which must have kept what static solutions
     * need; @p W is its static compliance.
     */
    ReducedRolling(std::shared_ptr<ModalBodies<dim>> modes,
                   const RollingPair<dim>           &pair,
                   const DenseMatrix                &W,
                   const RollingConditions          &conditions);

    /** RollingModes::compliance_at_rest() of these bodies. */
    DenseMatrix compliance_at_rest(DenseMatrix W) const
    {
      return bodies.compliance_at_rest(std::move(W));
    }

    void set_time_step(const double h) override;

    bool compliance_depends_on_step() const override;

    DenseMatrix compliance() const override;

    std::vector<std::vector<double>>
    response(const std::vector<std::vector<double>> &forces) override;

    double displacement_factor() const override;

    bool laws_in_the_middle() const override;

    FreeMotion begin_step(const double hub_acceleration,
                          const bool   smooth) override;

    StepEnergy end_step(const ContactProblem &problem,
                        const ContactState   &state) override;

    void start_from(const ContactProblem &problem,
                    const ContactState   &state) override;

    double stored_energy() const override;

    std::vector<double> contact_velocity() const override;

    std::optional<double> wheel_velocity() const override;

    BodyDynamics::Memory memory_consumption() const override;

    BodyField displacement(const Side            side,
                           const ContactProblem &problem,
                           const ContactState   &state) const override;

    void watch(const WatchedPoints<dim> &points) override;

    std::vector<double> watched_displacement() const override;

    void remember() override;

    void go_back() override;

    PairMotion save() const override;

    void restore(const PairMotion     &saved,
                 const ContactProblem &problem,
                 const ContactState   &state) override;

    const ReducedPair *reduced_pair() const override
    {
      return &motion.bodies();
    }

    const ReducedState *reduced_state() const override
    {
      return &motion.state();
    }

  private:
    std::shared_ptr<ModalBodies<dim>> modal;
    const RollingModes<dim>           bodies;
    const RollingPair<dim>           &pair;
    const RollingConditions           conditions;
    ReducedMotion                     motion;
    ReducedState                      kept;
    DenseMatrix watched; ///< motion of points by the modes, kg^(-1/2)
    double      h = 0.;
  };
} // namespace RollingContact

#endif
