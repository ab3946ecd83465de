#ifndef rolling_contact_pair_layered_bodies_h
#define rolling_contact_pair_layered_bodies_h

#include <rolling_contact/references/layered_line.h>
#include <rolling_contact/scene/pair_spec.h>

namespace RollingContact
{
  /**
   * Wheel and rail as half-planes with their covers as layers on them; one
   * without a cover has a layer of thickness 0, a rigid one an infinite
   * modulus.
   */
  References::LayeredPair layered_pair(const PairSpec &scene);

  /**
   * The line contact of layered_pair() under a load per length (N/m), with the
   * radii along x. Throws InputError if a cover is thinner than a hundredth of
   * the half-width.
   */
  References::LayeredLine
  layered_line_contact(const PairSpec                &scene,
                       const double                   load_per_length,
                       const References::LineFriction friction);

  /**
   * The line contact of this half-width (m) without friction, see
   * layered_line_contact().
   */
  References::LayeredLine
  layered_line_contact_of_half_width(const PairSpec &scene,
                                     const double    half_width);
} // namespace RollingContact

#endif
