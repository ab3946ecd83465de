#include <rolling_contact/references/fastsim.h>
#include <rolling_contact/results/reference_3d.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  namespace
  {
    /**
     * What the theories ask for; flow is the direction of the material.
     */
    struct Conditions
    {
      Creepages                      creepages;
      References::HertzEllipse       hertz;
      References::CombinedElasticity elasticity;
      double                         friction;
      int                            flow;
    };

    /**
     * Names and the way to the force, which is still 0 in @p named.
     */
    struct Theory
    {
      NamedForce named;
      void (*find)(const Conditions &at, NamedForce &force);
    };

    /**
     * Kalker's linear theory first.
     */
    const std::vector<Theory> &theories()
    {
      namespace R           = References;
      static const auto set = [](const R::TangentialForce &found,
                                 NamedForce               &force) {
        force.x = found.x;
        force.y = found.y;
      };
      static const std::vector<Theory> all{
        {{"Kalker", "kalker", "Kalker, linear", false},
         [](const Conditions &at, NamedForce &force) {
           const R::CreepForces found =
             R::kalker_forces(at.creepages, at.hertz, at.elasticity, at.flow);
           force.x           = found.x;
           force.y           = found.y;
           force.spin_moment = found.spin_moment;
         }},
        {{"Shen-Hedrick-Elkins", "shen", "Shen, Hedrick, Elkins"},
         [](const Conditions &at, NamedForce &force) {
           set(R::shen_hedrick_elkins(
                 at.creepages, at.hertz, at.elasticity, at.friction, at.flow),
               force);
         }},
        {{"FASTSIM", "fastsim", "FASTSIM"},
         [](const Conditions &at, NamedForce &force) {
           set(R::fastsim(
                 at.creepages, at.hertz, at.elasticity, at.friction, at.flow),
               force);
         }}};
      return all;
    }
  } // namespace

  Reference3D reference_3d(const PairSpec  &scene,
                           const double     normal_force,
                           const Creepages &creepages)
  {
    const PairConstants constants = pair_constants(scene);
    const Conditions    conditions{
      creepages,
      References::hertz_ellipse(normal_force,
                                0.5 / constants.relative_radius,
                                0.5 / constants.lateral_relative_radius,
                                constants.contact_modulus),
      constants.elasticity,
      scene.contact.friction_coefficient,
      scene.contact.flow()};
    const bool is_constant = scene.contact.friction_coefficient > 0. &&
                             scene.contact.has_constant_friction();
    Reference3D reference{conditions.hertz, {}};
    for (const Theory &theory : theories())
      if (is_constant || !theory.named.saturates)
        {
          reference.forces.push_back(theory.named);
          theory.find(conditions, reference.forces.back());
        }
    return reference;
  }

  NamedForce linear_theory(const PairSpec  &scene,
                           const double     half_width_x,
                           const double     half_width_y,
                           const Creepages &creepages)
  {
    const References::HertzEllipse ellipse{half_width_x,
                                           half_width_y,
                                           1.,
                                           0.}; // of any load
    const Theory                  &theory = theories().front();
    NamedForce                     force  = theory.named;
    theory.find({creepages,
                 ellipse,
                 pair_constants(scene).elasticity,
                 scene.contact.friction_coefficient,
                 scene.contact.flow()},
                force);
    return force;
  }

  std::string saturating_theories()
  {
    std::string names;
    for (const Theory &theory : theories())
      if (theory.named.saturates)
        names += (names.empty() ? "" : ", ") + theory.named.name;
    return names;
  }
} // namespace RollingContact
