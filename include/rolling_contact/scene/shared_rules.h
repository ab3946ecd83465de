#ifndef rolling_contact_scene_shared_rules_h
#define rolling_contact_scene_shared_rules_h

#include <rolling_contact/scene/scene_parameters.h>

#include <string>

namespace RollingContact
{
  /**
   * Throws InputError, with @p why in front, unless the steady state of a scene
   * is one that is linearised: without surfaces that pass, on one plane.
   */
  void check_disturbed_state(const SceneParameters &scene,
                             const std::string     &why);

  /**
   * Rules for analyses that linearise a steady rolling state. Throws
   * InputError.
   */
  void check_linearised_state(const SceneParameters &scene);

  /** Throws InputError where friction falls with the sliding speed and @p
   * entry, of @p text, gives speeds: the state is not the same at each. */
  void check_speeds_of_state(const SceneParameters &scene,
                             const std::string     &entry,
                             const std::string     &text);

  /**
   * Rules for analyses of each body alone. Throws InputError.
   */
  void check_lone_bodies(const SceneParameters &scene);

  /**
   * Rule for the modes of bodies as they are, which a rail without ends has
   * none of. Throws InputError.
   */
  void check_bodies_with_modes(const SceneParameters &scene);

  /**
   * Rules for analyses of rigid profiles. Throws InputError.
   */
  void check_rigid_profiles(const SceneParameters &scene);

  /**
   * Rules for analyses of many states. Throws InputError.
   */
  void check_table(const SceneParameters &scene);
} // namespace RollingContact

#endif
