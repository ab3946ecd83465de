#ifndef rolling_contact_time_slip_memory_h
#define rolling_contact_time_slip_memory_h

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
    NodalField sliding;    ///< of the nodes, 0 where they stick
    NodalField mean;       ///< TangentialProblem::mean_slip()
    double     power = 0.; ///< of friction
    double     debt  = 0.; ///< J: heat not yet taken back, see friction_heat()

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[sliding, mean, power, debt] = *this;
      archive &sliding &mean &power &debt;
    }
  };

  /**
   * The memory of a state at a speed, without what ContactLoads::slip_before
   * adds to its slip. Units: m/s.
   */
  SlipMemory slip_memory(const ContactProblem &problem,
                         const ContactState   &state,
                         const double          speed);

  /**
   * Which slip friction answers at each node in a step of the theta-scheme. At
   * nodes that slid at the end of the step before it is the slip at theta of
   * the step, theta of that at its end and 1 - theta of that before: there the
   * reactions act, so that their power is never positive, and their direction
   * is of second order in the step. At others it is the slip at the end. A node
   * that slid and now sticks answers the slip at the end as well: it comes to
   * rest, where at theta = 0.5 it would go on with the velocity reversed.
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
     * Let the nodes of a solution that come to rest answer the slip at the end.
     * False if there are no more.
     */
    bool bring_to_rest(const ContactProblem &problem,
                       const ContactState   &state,
                       ContactLoads         &loads) const;

  private:
    const SlipMemory &before;
  };

  /**
   * Heat of friction in a step of length @p h whose reactions act at @p theta
   * of it. The mean reaction of a node that comes to rest within the step may
   * push it in the mean, and the product of the means is negative then; where
   * that is so for all nodes together, the heat is zero and the rest, the debt
   * of @p after, is taken from that of the next steps. Units: s, J.
   */
  double heat_within_step(const SlipMemory     &before,
                          const double          theta,
                          const double          h,
                          const ContactProblem &problem,
                          const ContactState   &state,
                          SlipMemory           &after);
} // namespace RollingContact

#endif
