#ifndef rolling_contact_bodies_body_motion_h
#define rolling_contact_bodies_body_motion_h

#include <rolling_contact/base/exceptions.h>

#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * What a body has at the end of a step, component by component at each node;
   * constrained nodes are left out, and nodes are in an order of their own that
   * depends on the mesh only. Empty for a rigid body. Units: m, m/s.
   */
  struct BodyMotion
  {
    std::vector<double> displacement;
    std::vector<double> velocity;

    /** For Boost.Serialization. A member not listed here does not compile. */
    template <typename Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      auto &[displacement, velocity] = *this;
      archive &displacement &velocity;
    }
  };

  /**
   * Throws InputError unless it is the motion of this many unknowns.
   */
  inline void require_size(const BodyMotion &motion,
                           const std::size_t n_unknowns)
  {
    if (motion.displacement.size() != n_unknowns ||
        motion.velocity.size() != n_unknowns)
      throw InputError("Cannot resume: the checkpoint has " +
                       std::to_string(motion.displacement.size()) +
                       " unknowns of a body, the scene " +
                       std::to_string(n_unknowns) +
                       ". Start the run without --resume.");
  }
} // namespace RollingContact

#endif
