#ifndef rolling_contact_analyses_ellipse_reference_h
#define rolling_contact_analyses_ellipse_reference_h

#include <rolling_contact/analyses/steady_state.h>
#include <rolling_contact/references/fastsim.h>

namespace RollingContact
{
  /**
   * What half-space theory says of a 3D state at a given load: Hertz, Kalker's
   * linear theory, its saturation by Shen, Hedrick and Elkins, and FASTSIM. All
   * but the first are approximations, shown beside the result and no measure of
   * its error.
   */
  struct EllipseReference
  {
    References::HertzEllipse    hertz;
    References::CreepForces     linear;
    References::TangentialForce saturated;
    References::TangentialForce fastsim;
  };

  EllipseReference
  ellipse_reference(const SceneParameters       &scene,
                    const double                 normal_force,
                    const References::Creepages &creepages);
} // namespace RollingContact

#endif
