#ifndef rolling_contact_pair_patch_estimate_h
#define rolling_contact_pair_patch_estimate_h

#include <rolling_contact/mesh/zone_box.h>
#include <rolling_contact/references/contact_modulus.h>
#include <rolling_contact/scene/pair_spec.h>

#include <vector>

namespace RollingContact
{
  /**
   * Size of the patch by Hertz, for a given approach with approximate
   * compressions of the bodies, or by a half-space where profiles touch: what
   * the mesh is graded for before anything is solved. Line contacts of bodies
   * with covers are exact, of an ellipse the modulus is a mean over depth. All
   * members are zero if the bodies do not touch. Units: m, N.
   */
  struct PatchEstimate
  {
    double               half_width_x = 0.;
    double               half_width_y = 0.; ///< 3D
    double               normal_force = 0.;
    std::vector<ZoneBox> boxes; ///< of profiles; none: an ellipse
    /** Half-widths of the shortest and the narrowest of several patches; 0 for
     * an ellipse. */
    double shortest_x = 0., narrowest_y = 0.;

    /** Whether a point of the plane of contact is in it. */
    bool contains(const double x, const double y) const;
  };

  /**
   * Throws InputError if the approach is more than the bodies allow.
   */
  PatchEstimate estimate_patch(const PairSpec &scene);

  /**
   * Under this load (N) in place of the scene's, or with its approach if there
   * is none.
   */
  PatchEstimate estimate_patch(const PairSpec              &scene,
                               const std::optional<double> &load);

  /**
   * Whether there is a patch to estimate: a load or an approach above 0. With
   * profiles without the half-space, which takes 0.03 s.
   */
  bool bodies_touch(const PairSpec &scene);

  /**
   * Constants of Hertzian and tangential contact of wheel and rail, a rigid one
   * with infinite moduli; one with a cover has that of the cover, which rules
   * the edges of the patch. Units: Pa, m.
   */
  struct PairConstants
  {
    double contact_modulus         = 0.; ///< E*
    double relative_radius         = 0.; ///< in the rolling direction
    double lateral_relative_radius = 0.; ///< 3D, without profiles
    References::CombinedElasticity elasticity{0., 0.};

    /**
     * References::dundurs_beta() with the wheel as body 1: positive if the
     * wheel has the larger (1 - 2 nu)/G, zero if normal and tangential problem
     * are uncoupled.
     */
    double dundurs_beta = 0.;
  };

  PairConstants pair_constants(const PairSpec &scene);
} // namespace RollingContact

#endif
