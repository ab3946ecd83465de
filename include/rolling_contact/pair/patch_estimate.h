#ifndef rolling_contact_pair_patch_estimate_h
#define rolling_contact_pair_patch_estimate_h

#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  /**
   * Size of the patch from Hertz and approximate compressions of the bodies:
   * what the mesh is graded for before anything is solved. Zero without
   * contact. Units: m, N.
   */
  struct PatchEstimate
  {
    double half_width_x = 0.;
    double half_width_y = 0.; ///< 3D
    double normal_force = 0.;
  };

  PatchEstimate
  estimate_patch(const SceneParameters &scene);

  /**
   * Contact modulus E* and relative radius R of the pair. Units: Pa, m.
   */
  struct PairConstants
  {
    double contact_modulus         = 0.;
    double relative_radius         = 0.; ///< in the rolling direction
    double lateral_relative_radius = 0.; ///< 3D
    double dundurs_beta = 0.; ///< 0 if normal and tangential problem uncouple
  };

  PairConstants
  pair_constants(const SceneParameters &scene);
} // namespace RollingContact

#endif
