#ifndef rolling_contact_scene_disturbed_state_h
#define rolling_contact_scene_disturbed_state_h

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
} // namespace RollingContact

#endif
