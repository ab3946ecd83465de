#ifndef rolling_contact_dynamics_theta_stepper_h
#define rolling_contact_dynamics_theta_stepper_h

#include <rolling_contact/dynamics/theta_system.h>

#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * One body in time, u1 = u0 + h v_th with v_th = theta v1 + (1 - theta) v0,
   *   A v_th = M v0 - theta h K u0 + theta h (f + E r),
   * f constant nodal loads, r the reactions on the contact unknowns. A step is
   * begin_step(), one forward solve, then the contact solve by the caller, then
   * end_step(), one backward solve; in between, nothing but Y^T z and Y r. Owns
   * the state (u, v); ThetaSystem owns the matrices.
   */
  class ThetaStepper
  {
  public:
    /**
     * A body at rest and undeformed.
     */
    explicit ThetaStepper(std::shared_ptr<ThetaSystem> system);

    /**
     * Factorise for steps of this length; abandons a step that has begun.
     * Units: s.
     */
    void
    set_time_step(const double h);

    /**
     * Set displacement and velocity of all unknowns; abandons a step that has
     * begun. Units: m, m/s.
     */
    void
    set_state(const std::vector<double> &displacement,
              const std::vector<double> &velocity);

    /**
     * Set the nodal loads of all unknowns from now on; none if empty. Units: N.
     */
    void
    set_loads(const std::vector<double> &loads);

    void
    begin_step();

    /**
     * Forget a step that has begun; the state is that before it.
     */
    void
    abandon_step()
    {
      begun_step = 0.;
    }

    /**
     * Take the step with the given reactions on the contact unknowns. Units: N.
     */
    void
    end_step(const std::vector<double> &reactions);

    const std::vector<double> &
    displacement() const
    {
      return u;
    }

    const std::vector<double> &
    velocity() const
    {
      return v;
    }

    /**
     * Kinetic and strain energy of the state, and what the last step did.
     * Units: J.
     */
    const StepEnergy &
    energy() const
    {
      return step_energy;
    }

    /**
     * Displacement of the contact unknowns in the state. Units: m.
     */
    std::vector<double>
    contact_displacement() const;

    std::vector<double>
    contact_velocity() const;

    /**
     * What the step that has begun leads to on the contact unknowns without
     * reactions: v_th, v1 and u1.
     */
    const std::vector<double> &
    free_contact_theta_velocity() const;

    std::vector<double>
    free_contact_velocity() const;

    std::vector<double>
    free_contact_displacement() const;

    const ThetaSystem &
    system() const
    {
      return *matrices;
    }

  private:
    void
    require_begun() const;

    /**
     * Set u and K u at the end of the step from v_th in `work`, with the
     * energies that K takes part in.
     */
    void
    move_displacement();

    /**
     * Set v and M v at the end of the step from v_th in `work`, which becomes
     * dv, with the energies that M takes part in.
     */
    void
    change_velocity();

    std::vector<double>
    on_contact(const std::vector<double> &values) const;

    std::shared_ptr<ThetaSystem> matrices;
    std::vector<double>          u, v, Ku, Mv, f, z, work, free_theta_velocity;
    double                       begun_step = 0.; ///< h, 0 if none has begun
    StepEnergy                   step_energy;
  };
} // namespace RollingContact

#endif
