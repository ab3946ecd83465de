#ifndef rolling_contact_analyses_ellipse_reference_h
#define rolling_contact_analyses_ellipse_reference_h

#include <rolling_contact/analyses/steady_state.h>
#include <rolling_contact/references/hertz_ellipse.h>
#include <rolling_contact/references/kalker.h>
#include <rolling_contact/references/shen_hedrick_elkins.h>

namespace RollingContact
{
  /**
   * What half-space theory says of a 3D state at a given load: Hertz, Kalker's
   * linear theory and its saturation by Shen, Hedrick and Elkins. The last two
   * are approximations, shown beside the result and no measure of its error.
   */
  struct EllipseReference
  {
    References::HertzEllipse    hertz;
    References::CreepForces     linear;
    References::TangentialForce saturated;
  };

  EllipseReference
  ellipse_reference(const SceneParameters       &scene,
                    const double                 normal_force,
                    const References::Creepages &creepages);
} // namespace RollingContact

#endif
