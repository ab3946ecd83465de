#ifndef rolling_contact_motion_past_step_h
#define rolling_contact_motion_past_step_h

#include <vector>

namespace RollingContact
{
  /**
   * The last step of a scheme of two steps: the mean velocity in it, and its
   * length, 0 for a steady state, which takes that of the next step. No
   * velocity if there was none. Of bodies by their modes: forces at the middles
   * of the last two steps, the time between these, and the load that keeps the
   * state they began with, see ReducedState. Units: m/s, s, N, m kg^(1/2)/s^2.
   */
  struct PastStep
  {
    std::vector<double> velocity; ///< tangential, of the pair
    double              length = 0.;
    std::vector<double> forces, forces_before, load;
    double              distance = 0.;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      auto &[velocity, length, forces, forces_before, load, distance] = *this;
      archive &velocity &length &forces &forces_before &load &distance;
    }
  };
} // namespace RollingContact

#endif
