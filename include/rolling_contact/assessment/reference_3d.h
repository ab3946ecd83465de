#ifndef rolling_contact_assessment_reference_3d_h
#define rolling_contact_assessment_reference_3d_h

#include <rolling_contact/references/fastsim.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * What half-space theory says of a 3D state at a given load: Hertz, Kalker's
   * linear theory, its saturation by Shen, Hedrick and Elkins, and FASTSIM. All
   * but the first are approximations, shown beside the result and no measure of
   * its error.
   */
  struct Reference3D
  {
    References::HertzEllipse    hertz;
    References::CreepForces     linear;
    References::TangentialForce saturated;
    References::TangentialForce fastsim;
  };

  Reference3D
  reference_3d(const SceneParameters &scene,
               const double           normal_force,
               const Creepages       &creepages);
} // namespace RollingContact

#endif
