#ifndef rolling_contact_analyses_mesh_sizes_h
#define rolling_contact_analyses_mesh_sizes_h

#include <rolling_contact/analyses/scene_parameters.h>

namespace RollingContact
{
  /**
   * Throws InputError if the contact boundary of a mesh that was read is no
   * larger than the estimated patch, or its faces are so much larger that its
   * unit must be wrong. A flat one shows this by nothing else before the pair
   * of bodies is built.
   */
  void
  check_mesh_sizes(const SceneParameters &scene);
} // namespace RollingContact

#endif
