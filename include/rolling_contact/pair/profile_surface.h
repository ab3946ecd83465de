#ifndef rolling_contact_pair_profile_surface_h
#define rolling_contact_pair_profile_surface_h

#include <rolling_contact/contact/contact_operators.h>
#include <rolling_contact/scene/pair_spec.h>

namespace RollingContact
{
  /**
   * The positions and normals of nodes at these places (x, s) of the surface of
   * contact. They lie between those of the rail and of the wheel that faces it,
   * divided by the softness of both, where the surfaces meet under load. A body
   * that moves across finds the other body at that slope. Beyond the end of the
   * rail the surface goes on in its plane. Empty where the surface of contact
   * is plane, and for bodies without profiles.
   */
  SurfaceFrames surface_frames(const PairSpec                    &scene,
                               const ContactOperators::Positions &at);

  /**
   * Gap of the profiles at a place (x, s) of the surface of contact; 1 cm where
   * one of them has ended. Units: m.
   */
  double gap_of_profiles(const PairSpec              &scene,
                         const std::array<double, 2> &at);

  /**
   * Rigid slip of the profiles beyond that of creepages, T components at each
   * node: what is left of the motion of the wheelset where that is known, of
   * given creepages what the curved surface has beyond them. Empty if there is
   * none. Units: 1.
   */
  NodalField slip_of_profiles(const PairSpec         &scene,
                              const ContactOperators &operators);
} // namespace RollingContact

#endif
