#ifndef rolling_contact_pair_pair_integrator_h
#define rolling_contact_pair_pair_integrator_h

#include <rolling_contact/pair/pair_motion.h>
#include <rolling_contact/pair/rolling_pair.h>
#include <rolling_contact/pair/watched_points.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/time_parameters.h>

#include <memory>
#include <optional>
#include <stdexcept>

namespace RollingContact
{
  struct ReducedPair;

  /**
   * Motion of the wheel relative to the rail at the nodes of the interface at
   * the end of a time step without reactions. A member is empty where it is
   * zero. Units: m, m/s.
   */
  struct FreeMotion
  {
    std::vector<double> displacement; ///< tangential u1, which B1 acts on
    std::vector<double> velocity;     ///< tangential v1
    std::vector<double> gap;          ///< what the contact law adds to the gap

    /** Change of the velocity over W r / h: 1, or more of a scheme that takes
     * it from several steps. */
    double velocity_factor = 1.;
  };

  /**
   * Motion of the bodies of a pair in time. Over a time step h nodal forces r
   * of the pair change, with W = compliance(), the gap by W r, the displacement
   * by displacement_factor() W r and the velocity by
   * FreeMotion::velocity_factor W r / h. A step is begin_step(), the contact
   * solve by the caller, end_step(). What concerns the pair is the same on all
   * ranks. Functions are collective unless they say otherwise.
   */
  template <int dim>
  class PairIntegrator
  {
  public:
    virtual ~PairIntegrator() = default;

    /**
     * Prepare steps of this length. Units: s.
     */
    virtual void set_time_step(const double h) = 0;

    /**
     * False if W is the static compliance, whatever the step. Not collective.
     */
    virtual bool compliance_depends_on_step() const = 0;

    /**
     * Compliance W of the pair over a step, as in ContactProblem; empty if it
     * does not depend on the step. Units: m/N.
     */
    virtual DenseMatrix compliance() const = 0;

    /**
     * W r in the step that has begun for each of several sets of nodal forces
     * r, see RollingPair::response(). Units: N to m.
     */
    virtual std::vector<std::vector<double>>
    response(const std::vector<std::vector<double>> &forces) = 0;

    /**
     * Ratio of the change of the displacement that B1 acts on to that of the
     * gap: theta of the theta-scheme, or 1. Not collective.
     */
    virtual double displacement_factor() const = 0;

    /**
     * True if forces and laws of contact belong to the middle of a step, as do
     * the motions of begin_step(); false if the laws hold at its end. Not
     * collective.
     */
    virtual bool laws_in_the_middle() const
    {
      return false;
    }

    /**
     * Velocity of wheel relative to rail at the nodes in the last step, where
     * its reactions act; empty without inertia. Collective. Units: m/s.
     */
    virtual std::vector<double> contact_velocity() const
    {
      return {};
    }

    /**
     * Begin a step, in place of one that was begun and not ended, and return
     * the motion without reactions. @p hub_acceleration is that of the wheel's
     * hub towards the rail; @p smooth is false if what drives the pair jumps in
     * this step, so that what was before it says nothing. Units: m/s^2.
     */
    virtual FreeMotion begin_step(const double hub_acceleration,
                                  const bool   smooth) = 0;

    /**
     * End the step with the reactions of a contact state, and return the sum of
     * the energies of both bodies. Units: J.
     */
    virtual StepEnergy end_step(const ContactProblem &problem,
                                const ContactState   &state) = 0;

    /**
     * Set the bodies to rest in static equilibrium with a contact state.
     */
    virtual void start_from(const ContactProblem &problem,
                            const ContactState   &state) = 0;

    /**
     * Sum of the kinetic and strain energy of both bodies. Units: J.
     */
    virtual double stored_energy() const = 0;

    /**
     * Velocity along z of the centre of mass of a wheel whose hub is free; none
     * for others. Collective. Units: m/s.
     */
    virtual std::optional<double> wheel_velocity() const
    {
      return {};
    }

    /**
     * Memory in bytes on this rank of what the time steps keep for both bodies.
     * Not collective.
     */
    virtual BodyDynamics::Memory memory_consumption() const = 0;

    /**
     * Number of solves and iterations in a step, for the log; may be empty. Not
     * collective.
     */
    virtual std::string description() const
    {
      return "";
    }

    /**
     * Displacement of a body in its own frame, on the ranks that hold a part of
     * it, empty on others. Units: m.
     */
    virtual BodyField displacement(const Side            side,
                                   const ContactProblem &problem,
                                   const ContactState   &state) const = 0;

    /**
     * Follow the motion of these points from now on. Collective.
     */
    virtual void watch(const WatchedPoints<dim> &)
    {
      throw std::logic_error("Points are watched in bodies with inertia.");
    }

    /**
     * Displacement of the points that are watched, in the order of
     * WatchedPoints; of bodies by their modes without what the residual
     * compliance adds. Collective. Units: m.
     */
    virtual std::vector<double> watched_displacement() const
    {
      return {};
    }

    /**
     * Keep the state of the bodies for go_back(), in place of one kept before.
     */
    virtual void remember() = 0;

    /**
     * Return to the state that remember() kept.
     */
    virtual void go_back() = 0;

    /**
     * The motion for a checkpoint: that of a direct body on all ranks, that of
     * a distributed one on the first rank.
     */
    virtual PairMotion save() const = 0;

    /**
     * Go on from @p motion, which save() returned and all ranks have, and from
     * the problem and the contact state of the last step. Throws InputError if
     * it is the motion of other meshes.
     */
    virtual void restore(const PairMotion     &motion,
                         const ContactProblem &problem,
                         const ContactState   &state) = 0;

    /**
     * The equations of bodies by their modes; nullptr for other bodies. Not
     * collective.
     */
    virtual const ReducedPair *reduced_pair() const
    {
      return nullptr;
    }

    /**
     * The state of bodies by their modes, that of save(); nullptr for other
     * bodies. Not collective.
     */
    virtual const ReducedState *reduced_state() const
    {
      return nullptr;
    }
  };

  /**
   * Bodies with mass, by the theta-scheme, at rest but for the scene's initial
   * velocity of a free wheel. The gap of the contact law is u0 + h v1, or that
   * of Jean's shifted configuration, u0 + h (1 - theta) v0 + h v1, as the scene
   * asks for. Collective.
   */
  template <int dim>
  std::unique_ptr<PairIntegrator<dim>>
  make_inertial_rolling(const BodySpec         &wheel,
                        const TimeParameters   &time,
                        const RollingPair<dim> &pair);

  /**
   * Bodies without mass, with the static W: u1 = W r, and v1 by BDF2. With the
   * mean velocities d1 = (u1 - u0)/h of the step and d0 of the one before, of
   * length h_0, and w = h/h_0,
   *   v1 = d1 + w / (1 + w) (d1 - d0);
   * in the first step from rest, and where what drives the pair jumps, v1 = d1.
   * Keeps a reference to the pair.
   */
  template <int dim>
  std::unique_ptr<PairIntegrator<dim>>
  make_quasi_static_rolling(const RollingPair<dim> &pair);
} // namespace RollingContact

#endif
