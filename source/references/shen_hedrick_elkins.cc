#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/shen_hedrick_elkins.h>

#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    /**
     * |F|/|F_linear|.
     */
    double saturation_factor(const double linear_force, const double bound)
    {
      if (linear_force >= 3 * bound)
        return linear_force > 0 ? bound / linear_force : 0;
      const double ratio = linear_force / bound;
      return 1 - ratio / 3 + ratio * ratio / 27;
    }
  } // namespace

  TangentialForce shen_hedrick_elkins(const Creepages          &creepages,
                                      const HertzEllipse       &contact,
                                      const CombinedElasticity &elasticity,
                                      const double friction_coefficient,
                                      const int    flow_direction)
  {
    check_not_negative("Friction coefficient", friction_coefficient);
    const CreepForces linear =
      kalker_forces(creepages, contact, elasticity, flow_direction);
    const double factor =
      saturation_factor(std::hypot(linear.x, linear.y),
                        friction_coefficient * contact.load());
    return {factor * linear.x, factor * linear.y};
  }
} // namespace RollingContact::References
