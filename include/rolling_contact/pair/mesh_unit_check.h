#ifndef rolling_contact_pair_mesh_unit_check_h
#define rolling_contact_pair_mesh_unit_check_h

#include <rolling_contact/scene/pair_spec.h>

namespace RollingContact
{
  /**
   * Throw InputError if the contact boundary of a mesh that was read is no
   * larger than the estimated patch, or its faces are so much larger than the
   * patch that Mesh unit must be wrong. Nothing else shows this for a flat
   * boundary before the pair of bodies is built.
   */
  void check_mesh_units(const PairSpec &scene);
} // namespace RollingContact

#endif
