#ifndef rolling_contact_pair_pair_integrator_h
#define rolling_contact_pair_pair_integrator_h

#include <rolling_contact/dynamics/body_motion.h>
#include <rolling_contact/pair/rolling_pair.h>

#include <memory>

namespace RollingContact
{
  /**
   * What a time step leads to on the contact nodes without reactions: the
   * displacement u1 of the wheel over the rail that B1 acts on, and its
   * velocity v1, of the tangential components; and what is added to the gap in
   * the contact law. Empty where it is zero. Units: m, m/s.
   */
  struct FreeMotion
  {
    std::vector<double> displacement;
    std::vector<double> velocity;
    std::vector<double> gap;
  };

  /**
   * How the surfaces of a pair answer their reactions over a time step h: with
   * W = compliance(), the gap changes by W r, the displacement by
   * displacement_factor() W r and the velocity by W r / h. A step is
   * begin_step(), the contact solve by the caller, end_step().
   */
  template <int dim>
  class PairIntegrator
  {
  public:
    virtual ~PairIntegrator() = default;

    /**
     * Units: s.
     */
    virtual void
    set_time_step(const double h) = 0;

    /**
     * False if W is the static compliance, whatever the step.
     */
    virtual bool
    compliance_depends_on_step() const = 0;

    /**
     * Of the pair, as in ContactProblem, if it depends on the step. Units: m/N.
     */
    virtual DenseMatrix
    compliance() const = 0;

    /**
     * W r of the bodies for nodal forces r, as RollingPair::response(), in the
     * step that has begun.
     */
    virtual std::vector<std::vector<double>>
    response(const std::vector<std::vector<double>> &forces) = 0;

    virtual double
    displacement_factor() const = 0;

    /**
     * Motion without reactions; a step that has begun before is forgotten. @p
     * hub_acceleration is that of the wheel's hub towards the rail. Units:
     * m/s^2.
     */
    virtual FreeMotion
    begin_step(const double hub_acceleration) = 0;

    /**
     * Take the step with the reactions of a state; energies of both bodies.
     */
    virtual StepEnergy
    end_step(const ContactProblem &problem, const ContactState &state) = 0;

    /**
     * The bodies' state in static equilibrium with a contact state, at rest.
     */
    virtual void
    start_from(const ContactProblem &problem, const ContactState &state) = 0;

    /**
     * Kinetic and strain energy of the state. Units: J.
     */
    virtual double
    stored_energy() const = 0;

    /**
     * What the time step keeps for all bodies, in bytes.
     */
    virtual BodyDynamics::Memory
    memory_consumption() const = 0;

    /**
     * What the steps of the bodies took, for the log; may be empty.
     */
    virtual std::string
    description() const
    {
      return "";
    }

    /**
     * For fields, in the body's own frame. Units: m.
     */
    virtual BodyField
    displacement(const Side            side,
                 const ContactProblem &problem,
                 const ContactState   &state) const = 0;

    /**
     * Keep the bodies' state now for go_back().
     */
    virtual void
    remember() = 0;

    virtual void
    go_back() = 0;

    /**
     * The bodies' state at the end of the last step. Collective.
     */
    virtual PairMotion
    save() const = 0;

    /**
     * Go on from a saved state; @p problem and @p state are those of the step
     * it was saved after.
     */
    virtual void
    restore(const PairMotion     &saved,
            const ContactProblem &problem,
            const ContactState   &state) = 0;
  };

  /**
   * Bodies with mass, by the theta-scheme. @p shifted takes the gap of Jean's
   * shifted configuration, u0 + h (1 - theta) v0 + h v1, else u0 + h v1.
   */
  template <int dim>
  std::unique_ptr<PairIntegrator<dim>>
  make_inertial_rolling(const SceneParameters  &scene,
                        const RollingPair<dim> &pair);

  /**
   * Bodies without mass: u1 = W r with the static W and v1 = (u1 - u0)/h.
   */
  template <int dim>
  std::unique_ptr<PairIntegrator<dim>>
  make_quasi_static_rolling(const RollingPair<dim> &pair);
} // namespace RollingContact

#endif
