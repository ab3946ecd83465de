#ifndef rolling_contact_tests_disc_on_block_h
#define rolling_contact_tests_disc_on_block_h

#include "scene_run.h"

/**
 * A disc pressed by 50 kN on a crowned block, wide enough for a split
 * compliance.
 */
inline void set_disc_on_block(RollingContact::SceneParameters &scene)
{
  scene.dimension           = 3;
  scene.wheel.radius        = 0.46;
  scene.wheel.hub_radius    = 0.1;
  scene.wheel.width         = 0.135;
  scene.rail.shape          = "block";
  scene.rail.radius         = 0.;
  scene.rail.lateral_radius = 0.3;
  scene.rail.block_length   = 0.4;
  scene.rail.block_depth    = 0.16;
  scene.rail.width          = 0.09;
  scene.contact.normal_load = 50e3;
  scene.contact.approach.reset();
}

#endif
