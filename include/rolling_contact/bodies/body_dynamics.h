#ifndef rolling_contact_bodies_body_dynamics_h
#define rolling_contact_bodies_body_dynamics_h

#include <deal.II/lac/la_parallel_vector.h>

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/bodies/body_motion.h>
#include <rolling_contact/bodies/theta_scheme.h>

#include <memory>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Nodal values of a body, hanging and clamped nodes included; of a
   * distributed body those of this rank and its ghosts.
   */
  using BodyField = dealii::LinearAlgebra::distributed::Vector<double>;

  /**
   * One body in time, by the theta-scheme, with forces on its contact nodes.
   * A step is begin_step(), the contact solve by the caller, end_step(). Forces
   * and motions of contact nodes are in the order of ElasticBody::compliance().
   */
  class BodyDynamics
  {
  public:
    virtual ~BodyDynamics() = default;

    /**
     * Another state of the same body, at rest and undeformed, that shares its
     * matrices and takes its steps with this one: begin_twin_steps(). It must
     * live as long as steps of both are taken.
     */
    virtual std::unique_ptr<BodyDynamics> make_twin() = 0;

    /**
     * Prepare steps of this length. Units: s.
     */
    virtual void set_time_step(const double h) = 0;

    /**
     * Compliance h^2 E^T A^-1 E of the contact nodes over a step, see
     * ThetaSystem; exact, or an approximation that response() corrects. On the
     * rank of ElasticBody::compliance(), empty on others. Units: m/N.
     */
    virtual const DenseMatrix &contact_compliance() const = 0;

    /**
     * What nodal forces r do to the contact nodes in the step that has begun,
     * h^2 E^T A^-1 E r. Units: N to m.
     */
    virtual std::vector<double>
    response(const std::vector<double> &reactions) = 0;

    /**
     * Set the state to rest under a static displacement. Units: m.
     */
    virtual void set_static_state(const BodyField &displacement) = 0;

    /**
     * Set the state to undeformed and flying along z of the body's own frame.
     * Units: m/s.
     */
    virtual void set_flight_velocity(const double velocity) = 0;

    /**
     * Accelerate the hub along z of the body's own frame from now on: loads -M
     * e_z a. Units: m/s^2.
     */
    virtual void accelerate_hub(const double acceleration) = 0;

    /**
     * Velocity of the centre of mass of all that is not held, along z of the
     * body's own frame: the momentum over the mass. Collective for a
     * distributed body. Units: m/s.
     */
    virtual double mean_velocity() = 0;

    virtual void begin_step() = 0;

    /**
     * Take the step with the given reactions on the contact nodes. Units: N.
     */
    virtual void end_step(const std::vector<double> &reactions) = 0;

    /**
     * Begin the steps of this state and of its twin, see make_twin(): a factor
     * is read once for both, the digits are those of begin_step(). Throws
     * std::logic_error without a twin.
     */
    virtual void begin_twin_steps() = 0;

    /**
     * Take the steps of this state and of its twin. Units: N.
     */
    virtual void end_twin_steps(const std::vector<double> &reactions,
                                const std::vector<double> &twin_reactions) = 0;

    /**
     * Displacement of the contact nodes in the state. Units: m.
     */
    virtual std::vector<double> contact_displacement() const = 0;

    virtual std::vector<double> contact_velocity() const = 0;

    /**
     * What the step that has begun leads to on the contact nodes without
     * reactions: u1 and v1.
     */
    virtual std::vector<double> free_contact_displacement() const = 0;

    virtual std::vector<double> free_contact_velocity() const = 0;

    /**
     * Kinetic and strain energy of the state, and what the last step did.
     * Units: J.
     */
    virtual const StepEnergy &energy() const = 0;

    virtual BodyField displacement() const = 0;

    /**
     * Keep the state now for go_back(), in place of one kept before.
     */
    virtual void remember() = 0;

    virtual void go_back() = 0;

    /**
     * The state in an order that does not depend on the number of ranks; of a
     * distributed body on the first rank, empty on others.
     */
    virtual BodyMotion save() const = 0;

    /**
     * Take a saved state. Throws InputError if it is one of another mesh.
     */
    virtual void restore(const BodyMotion &motion) = 0;

    /**
     * Memory of the body in bytes.
     */
    struct Memory
    {
      std::size_t matrices = 0; ///< K and M
      std::size_t solver   = 0; ///< factor or preconditioner
      std::size_t columns  = 0; ///< Y
    };

    virtual Memory memory_consumption() const = 0;

    /**
     * What the steps so far took, for the log; empty if there is nothing to
     * tell.
     */
    virtual std::string description() const
    {
      return "";
    }
  };
} // namespace RollingContact

#endif
