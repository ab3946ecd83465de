#ifndef rolling_contact_tests_wheel_on_block_h
#define rolling_contact_tests_wheel_on_block_h

#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  /** A wheel on a block, to be given profiles and a load. */
  inline SceneParameters wheel_on_block(const unsigned int elements_across)
  {
    SceneParameters scene;
    scene.dimension                  = 3;
    scene.wheel.hub_radius           = 0.1;
    scene.wheel.width                = 0.1;
    scene.rail.shape                 = "block";
    scene.rail.radius                = 0.;
    scene.rail.block_length          = 0.3;
    scene.rail.block_depth           = 0.15;
    scene.rail.width                 = 0.1;
    scene.mesh.elements_across_patch = elements_across;
    scene.mesh.growth                = 0.8;
    return scene;
  }
} // namespace RollingContact

#endif
