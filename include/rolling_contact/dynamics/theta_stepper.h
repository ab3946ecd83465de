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
     * Begin the step of two states of the same body, with the same loads or
     * others: the factor is read once for both, the digits are those of
     * begin_step(). Throws std::logic_error unless they share their matrices.
     */
    static void
    begin_steps(ThetaStepper &first, ThetaStepper &second);

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

    /**
     * Take the step of two states of the same body, as begin_steps().
     */
    static void
    end_steps(ThetaStepper              &first,
              const std::vector<double> &first_reactions,
              ThetaStepper              &second,
              const std::vector<double> &second_reactions);

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

    void
    require_same_matrices(const ThetaStepper &other) const;

    /**
     * Set `work` to the momentum that the step begins with.
     */
    void
    begin_momentum();

    /**
     * Set u at the end of the step from v_th in `work`, with the work of the
     * reactions, loads and damping; uses `z`; returns the energy before.
     */
    double
    move_displacement(const std::vector<double> &reactions);

    /**
     * Take K u at the end of the step from `z`, with the energies that K takes
     * part in, and v from v_th in `work`, which becomes dv.
     */
    void
    change_velocity();

    /**
     * Take M v at the end of the step from `z`, with the energies that M takes
     * part in.
     */
    void
    finish_step(const double energy_before);

    std::vector<double>
    on_contact(const std::vector<double> &values) const;

    std::shared_ptr<ThetaSystem> matrices;
    std::vector<double>          u, v, Ku, Mv, f, z, work, free_theta_velocity;
    double                       begun_step = 0.; ///< h, 0 if none has begun
    StepEnergy                   step_energy;
  };
} // namespace RollingContact

#endif
