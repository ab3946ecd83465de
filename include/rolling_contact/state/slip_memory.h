#ifndef rolling_contact_state_slip_memory_h
#define rolling_contact_state_slip_memory_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/contact/contact_state.h>

namespace RollingContact
{
  /**
   * The sliding at the end of a time step, which the next one begins with. Of
   * velocities, slips times the speed: it may change. Empty without friction.
   * Units: m/s, W.
   */
  struct SlipMemory
  {
    NodalField sliding;    ///< of the nodes that slide, 0 elsewhere
    NodalField mean;       ///< TangentialProblem::mean_slip()
    double     power = 0.; ///< of friction

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      auto &[sliding, mean, power] = *this;
      archive &sliding &mean &power;
    }
  };

  /**
   * The memory of a state at a speed, without what ContactLoads::slip_before
   * adds to its slip. Units: m/s.
   */
  SlipMemory
  slip_memory(const ContactProblem &problem,
              const ContactState   &state,
              const double          speed);

  /**
   * Which slip friction answers at each node in a step of the theta-scheme. At
   * nodes that slid at the end of the step before it is the slip at theta of
   * the step, theta of that at its end and 1 - theta of that before: there the
   * reactions act, so that their power is never positive, and their direction
   * is of second order in the step. At others it is the slip at the end. A node
   * that slid and now sticks answers the slip at the end as well, and comes to
   * rest, where at theta = 0.5 it would go on with the velocity reversed;
   * unless friction would have to push it for that.
   */
  class SlipWithinStep
  {
  public:
    /**
     * Set @p loads for the first solution of a step. @p speed is that at the
     * end. Units: m/s.
     */
    SlipWithinStep(const SlipMemory &before,
                   const double      theta,
                   const double      speed,
                   ContactLoads     &loads);

    /**
     * Change @p loads as a solution asks for; false if it does not. Each node
     * changes twice at most.
     */
    bool
    change(const ContactProblem &problem,
           const ContactState   &state,
           ContactLoads         &loads);

  private:
    void
    answer_end(const unsigned int node, ContactLoads &loads) const;

    void
    answer_theta(const unsigned int node, ContactLoads &loads) const;

    const SlipMemory         &before;
    const double              theta, speed;
    std::vector<unsigned int> n_changes; ///< of each node; empty if none answer
  };

  /**
   * Power of friction in a step whose reactions act at @p theta of it. Units:
   * W.
   */
  double
  power_within_step(const SlipMemory     &before,
                    const SlipMemory     &after,
                    const double          theta,
                    const ContactProblem &problem,
                    const ContactState   &state);
} // namespace RollingContact

#endif
