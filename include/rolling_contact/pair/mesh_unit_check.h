#ifndef rolling_contact_pair_mesh_unit_check_h
#define rolling_contact_pair_mesh_unit_check_h

#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  /**
   * Throws InputError if the contact boundary of a mesh that was read is no
   * larger than the estimated patch, or its faces are so much larger that its
   * unit must be wrong. A flat one shows this by nothing else before the pair
   * of bodies is built.
   */
  void
  check_mesh_units(const SceneParameters &scene);
} // namespace RollingContact

#endif
