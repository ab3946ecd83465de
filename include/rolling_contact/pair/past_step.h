#ifndef rolling_contact_pair_past_step_h
#define rolling_contact_pair_past_step_h

#include <vector>

namespace RollingContact
{
  /**
   * The last step of a scheme of two steps: the mean velocity in it, and its
   * length, 0 for a steady state, which takes that of the next step. No
   * velocity if there was none. Units: m/s, s.
   */
  struct PastStep
  {
    std::vector<double> velocity; ///< tangential, of the pair
    double              length = 0.;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      auto &[velocity, length] = *this;
      archive &velocity &length;
    }
  };
} // namespace RollingContact

#endif
