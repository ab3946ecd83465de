#include <rolling_contact/assessment/reference_3d.h>
#include <rolling_contact/references/contact_modulus.h>

#include <limits>

namespace RollingContact
{
  Reference3D
  reference_3d(const SceneParameters &scene,
               const double           normal_force,
               const Creepages       &creepages)
  {
    const PairConstants constants = pair_constants(scene);
    const auto          modulus   = [](const BodyParameters &body) {
      return body.rigid ? std::numeric_limits<double>::infinity()
                                   : body.material.young_modulus;
    };
    const References::CombinedElasticity elasticity =
      References::combined_elasticity(modulus(scene.wheel),
                                      scene.wheel.material.poisson_ratio,
                                      modulus(scene.rail),
                                      scene.rail.material.poisson_ratio);
    Reference3D reference{
      References::hertz_ellipse(normal_force,
                                0.5 / constants.relative_radius,
                                0.5 / constants.lateral_relative_radius,
                                constants.contact_modulus),
      {},
      {},
      {}};
    const int flow = scene.contact.flow();
    reference.linear =
      References::kalker_forces(creepages, reference.hertz, elasticity, flow);
    const double mu = scene.contact.friction_coefficient;
    if (mu == 0.)
      return reference;
    reference.saturated = References::shen_hedrick_elkins(
      creepages, reference.hertz, elasticity, mu, flow);
    reference.fastsim =
      References::fastsim(creepages, reference.hertz, elasticity, mu, flow);
    return reference;
  }
} // namespace RollingContact
