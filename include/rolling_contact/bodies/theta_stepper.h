#ifndef rolling_contact_bodies_theta_stepper_h
#define rolling_contact_bodies_theta_stepper_h

#include <rolling_contact/bodies/body_dynamics.h>
#include <rolling_contact/bodies/theta_system.h>

#include <memory>
#include <vector>

namespace RollingContact
{
  /**
   * The steps of one body in time, u1 = u0 + h v_th with
   * v_th = theta v1 + (1 - theta) v0,
   *   A v_th = M v0 - theta h K u0 + theta h (f + E r),
   * f constant nodal loads, r the reactions on the contact unknowns. Owns the
   * state (u, v); the system, a ThetaSystem or a DistributedThetaSystem, owns
   * the matrices and solves with A. Of a distributed body functions are
   * collective but for remember(), go_back() and what only returns a value.
   */
  template <typename System>
  class ThetaStepper : public BodyDynamics
  {
  public:
    using Vector = typename System::Vector;

    /**
     * A body at rest and undeformed.
     */
    explicit ThetaStepper(std::shared_ptr<System> system);

    /**
     * Prepare steps of this length; abandons a step that has begun. Units: s.
     */
    void set_time_step(const double h) override;

    /**
     * Set displacement and velocity of all unknowns; abandons a step that has
     * begun. Units: m, m/s.
     */
    void set_state(const Vector &displacement, const Vector &velocity);

    /**
     * Set the nodal loads of all unknowns from now on, none if empty; abandons
     * a step that has begun. Units: N.
     */
    void set_loads(const Vector &loads);

    void begin_step() override
    {
      begin_steps({this});
    }

    /**
     * Take steps with another state of the same body from now on. Throws
     * std::logic_error unless they are two and share their matrices.
     */
    void step_with(ThetaStepper &other);

    void begin_twin_steps() override
    {
      begin_steps({this, &the_twin()});
    }

    void end_step(const std::vector<double> &reactions) override
    {
      end_steps({this}, {&reactions});
    }

    void end_twin_steps(const std::vector<double> &reactions,
                        const std::vector<double> &twin_reactions) override
    {
      end_steps({this, &the_twin()}, {&reactions, &twin_reactions});
    }

    const DenseMatrix &contact_compliance() const override
    {
      return system->contact_compliance();
    }

    std::vector<double> response(const std::vector<double> &reactions) override;

    /**
     * Displacement and velocity of all unknowns. Units: m, m/s.
     */
    const Vector &displacements() const
    {
      return now.u;
    }

    const Vector &velocities() const
    {
      return now.v;
    }

    const StepEnergy &energy() const override
    {
      return now.energy;
    }

    std::vector<double> contact_displacement() const override
    {
      return system->on_contact(now.u);
    }

    std::vector<double> contact_velocity() const override
    {
      return system->on_contact(now.v);
    }

    /**
     * v_th of the contact unknowns that the step that has begun leads to
     * without reactions. Units: m/s.
     */
    const std::vector<double> &free_contact_theta_velocity() const;

    std::vector<double> free_contact_velocity() const override;

    std::vector<double> free_contact_displacement() const override;

    void remember() override
    {
      kept = now;
    }

    void go_back() override;

    Memory memory_consumption() const override
    {
      return system->memory();
    }

    std::string description() const override
    {
      return work.description();
    }

    const std::shared_ptr<System> system;

  private:
    struct State
    {
      State() = default;

      /** Vectors of one layout: to be copied by one rank alone. */
      explicit State(const Vector &zero)
        : u(zero)
        , v(zero)
        , Ku(zero)
        , Mv(zero)
      {}

      Vector     u, v, Ku, Mv;
      StepEnergy energy;
    };

    /**
     * Begin or take the step of one state or of two of the same body.
     */
    static void begin_steps(const std::vector<ThetaStepper *> &states);

    static void
    end_steps(const std::vector<ThetaStepper *>              &states,
              const std::vector<const std::vector<double> *> &reactions);

    /**
     * Forget the step that has begun and what solves began with.
     */
    void start_anew();

    void require_begun() const;

    /**
     * Throws std::logic_error if there is none.
     */
    ThetaStepper &the_twin() const;

    /**
     * Set the momentum that the step begins with.
     */
    void begin_momentum();

    /**
     * Set u at the end of the step from v_th, with the work of the reactions,
     * loads and damping; returns the energy before.
     */
    double move_displacement(const std::vector<double> &reactions);

    /**
     * Take K u at the end of the step from `z`, with the energies that K takes
     * part in, and v from v_th, which becomes dv.
     */
    void change_velocity();

    /**
     * Take M v at the end of the step from `z`, with the energies that M takes
     * part in.
     */
    void finish_step(const double energy_before);

    State                 now, kept;
    Vector                f;
    typename System::Work work;
    ThetaStepper         *twin       = nullptr; ///< see step_with()
    double                begun_step = 0.;      ///< h, 0 if none has begun
  };
} // namespace RollingContact

#endif
