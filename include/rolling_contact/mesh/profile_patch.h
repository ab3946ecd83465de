#ifndef rolling_contact_mesh_profile_patch_h
#define rolling_contact_mesh_profile_patch_h

#include <rolling_contact/mesh/material.h>
#include <rolling_contact/mesh/zone_box.h>
#include <rolling_contact/surfaces/contact_frame.h>

#include <memory>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * The patch, or patches, of half-spaces with the surfaces of profiles: what
   * the mesh is made for. Units: m, N, rad.
   */
  struct ProfilePatch
  {
    std::vector<ZoneBox> boxes; ///< that touch, side by side
    double half_width_x = 0.;   ///< half of the longest stretch along x
    double half_width_y = 0.;   ///< of the widest patch
    /**
     * Half-lengths in x of the shortest, and in y of the narrowest, of the
     * patches that carry a tenth of the load or more. Units: m.
     */
    double shortest_x = 0., narrowest_y = 0.;
    double normal_force = 0.;
    double approach     = 0.;
    /** By how much the rail's normal turns over 90 % of the load. */
    double turn_of_normal = 0.;
    /** Means over the load of the heaviest patch: where it is across, and the
     * rail's slope against the plane there, which is also that of the wheel. */
    double middle = 0., slope = 0.;
  };

  /**
   * Half-spaces that are pressed onto each other by a load or, if there is
   * none, with an approach; a rigid one has no material. Units: N, m.
   */
  struct PressedHalfSpaces
  {
    bool operator==(const PressedHalfSpaces &other) const;

    std::optional<Material> wheel, rail;
    std::optional<double>   load;
    double                  approach = 0.;
  };

  /**
   * Frame in the plane at the patch of profile_patch(), found in two rounds
   * from that of the @p first contact: the plane against which the mean slope
   * over the load is 0. The first if nothing presses or both are rigid.
   */
  std::shared_ptr<const Profiles::ContactFrame>
  frame_at_patch(std::shared_ptr<const Profiles::ContactFrame> first,
                 const PressedHalfSpaces                      &bodies);

  /**
   * Patch between half-spaces with the contact modulus E* (Pa) on a coarse
   * grid, under a load or, if there is none, with an approach. All members are
   * zero if the surfaces do not touch. On a curved surface of contact load and
   * approach are inclined against the normal of its plane by an angle (rad),
   * see SurfaceFrames. Throws InputError if the patch reaches the ends of the
   * profiles.
   */
  ProfilePatch profile_patch(const Profiles::ContactFrame &frame,
                             const double                  contact_modulus,
                             const std::optional<double>  &load,
                             const double                  approach,
                             const double                  load_angle = 0.);
} // namespace RollingContact

#endif
