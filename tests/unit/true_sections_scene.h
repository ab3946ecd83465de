#ifndef rolling_contact_tests_true_sections_scene_h
#define rolling_contact_tests_true_sections_scene_h

#include <rolling_contact/scene/scene_parameters.h>

/**
 * S1002 on 60E1 with true sections, away from the corner of the rail.
 */
inline void set_true_sections(RollingContact::SceneParameters &scene)
{
  scene.dimension                  = 3;
  scene.wheel.hub_radius           = 0.095;
  scene.rail.shape                 = "block";
  scene.rail.radius                = 0.;
  scene.rail.block_length          = 0.6;
  scene.contact.normal_load        = 16e3;
  scene.mesh.elements_across_patch = 10;
  scene.mesh.growth                = 0.8;
  scene.output.body_fields         = false;
  scene.profiles.wheel_profile     = "S1002";
  scene.profiles.rail_profile      = "60E1";
  scene.profiles.shift             = 3e-3;
  scene.profiles.roll              = 0.;
  scene.profiles.true_sections     = true;
}

#endif
