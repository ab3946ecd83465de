#ifndef rolling_contact_pair_pair_motion_h
#define rolling_contact_pair_pair_motion_h

#include <rolling_contact/base/side.h>
#include <rolling_contact/bodies/body_motion.h>

#include <vector>

namespace RollingContact
{
  /**
   * The last step of a scheme of two steps: the mean tangential velocity of the
   * pair in it, empty if there was no step, and its length, 0 for a steady
   * state, which takes that of the next step. Units: m/s, s.
   */
  struct PastStep
  {
    std::vector<double> velocity;
    double              length = 0.;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[velocity, length] = *this;
      archive &velocity &length;
    }
  };

  /**
   * The state of wheel and rail by their modes at the end of a step: amplitudes
   * of the modes, those of the wheel first, and the nodal forces at the middles
   * of the last two steps, from which the rate of the residual displacement
   * follows. Units: m kg^(1/2), m kg^(1/2)/s, N, s.
   */
  struct ReducedState
  {
    std::vector<double> eta, rate;             ///< of the modes
    std::vector<double> forces, forces_before; ///< g of ReducedPair
    double              last_step = 0.;        ///< 0: none has been taken

    /** From the middle of the step before to that of the last one, s. */
    double distance = 0.;

    /**
     * Add @p factor times the amplitudes and forces of another state.
     */
    void add(const double factor, const ReducedState &other)
    {
      const auto add_to = [&](std::vector<double>       &to,
                              const std::vector<double> &from) {
        for (std::size_t i = 0; i < to.size(); ++i)
          to[i] += factor * from[i];
      };
      add_to(eta, other.eta);
      add_to(rate, other.rate);
      add_to(forces, other.forces);
      add_to(forces_before, other.forces_before);
    }

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[eta, rate, forces, forces_before, last_step, distance] = *this;
      archive &eta &rate &forces &forces_before &last_step &distance;
    }
  };

  /**
   * All that the next step of a PairIntegrator takes from those before it:
   * direct or distributed bodies with mass have the motion of each body, a pair
   * without mass its last step, bodies by their modes a reduced state. What is
   * not in use is empty.
   */
  struct PairMotion
  {
    PerSide<BodyMotion> bodies; ///< each of twins has its own motion
    PastStep            past;
    ReducedState        modes;

    /** For Boost.Serialization. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &bodies.wheel &bodies.rail &past &modes;
    }
  };
} // namespace RollingContact

#endif
