#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/shared_rules.h>

namespace RollingContact
{
  void check_disturbed_state(const SceneParameters &scene,
                             const std::string     &why)
  {
    if (scene.surfaces.in_use() || !scene.surfaces.friction_share.empty())
      throw InputError(why + "surfaces that pass (section Surfaces) have no "
                             "steady state; leave them empty.");
  }

  void check_linearised_state(const SceneParameters &scene)
  {
    const ContactParameters &contact = scene.contact;
    scene.modes.check();
    scene.stability.check();
    const std::string why = "Analysis = " + scene.analysis.name + ": ";
    if (!contact.speed)
      throw InputError(why + "Contact/Speed is empty; give the rolling speed V "
                             "in m/s, which the slip's rate is compared with.");
    if (contact.friction_coefficient > 0. &&
        contact.slip_operator == SlipOperatorKind::galerkin)
      throw InputError(why + "Contact/Slip operator must be `calibrated`, "
                             "`upwind 2` or `upwind 1`: that of `galerkin` has "
                             "no rows to linearise.");
    if (contact.friction_memory_length > 0.)
      throw InputError(why + "Contact/Friction memory length = " +
                       text_of(contact.friction_memory_length) +
                       ": a sliding distance is not among the linearised laws; "
                       "set it to 0.");
    check_disturbed_state(scene, why);
    if (scene.body_solver == BodySolver::distributed)
      throw InputError("Body solver = distributed: " + why +
                       "modes are found with a factor; take direct or "
                       "automatic, on one rank.");
    if (scene.mesh.adaptive_levels > 0 || scene.mesh.target_error)
      throw InputError(why + "Mesh/Adaptive levels and Target error are not "
                             "for it; give Mesh/Elements across patch.");
  }

  void check_speeds_of_state(const SceneParameters &scene,
                             const std::string     &entry,
                             const std::string     &text)
  {
    if (scene.contact.falling_friction() && !text.empty())
      throw InputError(entry + " = " + text +
                       ": friction that falls with the sliding speed has a "
                       "state of its own at each; leave Speeds empty and give "
                       "Contact/Speed.");
  }

  void check_lone_bodies(const SceneParameters &scene)
  {
    scene.modes.check();
    const std::string &name = scene.analysis.name;
    if (scene.wheel.rigid && scene.rail.rigid)
      throw InputError("Wheel/Rigid = true and Rail/Rigid = true: Analysis = " +
                       name + " needs an elastic body.");
    if (scene.body_solver == BodySolver::distributed)
      throw InputError("Body solver = distributed: Analysis = " + name +
                       " needs the factor of the stiffness, which blocks of "
                       "vectors are solved with; take direct or automatic, on "
                       "one rank.");
    if (!scene.wheel.rigid && scene.wheel.hub == Hub::mass &&
        scene.wheel.modes == ModeModel::harmonic)
      throw InputError("Wheel/Hub = mass and Wheel/Model = harmonic: alone, a "
                       "wheel on its axle has modes of its mesh; take Model = "
                       "mesh.");
    if (scene.profiles.in_use())
      scene.profiles.check(scene.wheel.radius, scene.prm_folder);
  }

  void check_bodies_with_modes(const SceneParameters &scene)
  {
    if (!scene.rail.rigid && scene.rail.modes == ModeModel::waveguide)
      throw InputError("Rail/Model = waveguide: a rail without ends has waves "
                       "in place of modes; take Analysis = receptance, which "
                       "tells them, or Model = mesh.");
  }

  void check_rigid_profiles(const SceneParameters &scene)
  {
    if (!scene.profiles.has_radius_difference())
      return scene.profiles.check(scene.wheel.radius, scene.prm_folder);
    scene.profiles.check_table();
    scene.profiles.radius_difference(scene.prm_folder);
  }

  void check_table(const SceneParameters &scene)
  {
    scene.table.check();
    const std::string why = ": the states of a table share bodies, whose "
                            "compliance is found once, on one mesh; ";
    if (scene.mesh.target_error)
      throw InputError(
        "Mesh/Target error = " + text_of(*scene.mesh.target_error) + why +
        "give Mesh/Elements across patch.");
    if (scene.mesh.adaptive_levels > 0)
      throw InputError(
        "Mesh/Adaptive levels = " + std::to_string(scene.mesh.adaptive_levels) +
        why + "set it to 0.");
    if (scene.body_solver == BodySolver::distributed)
      throw InputError("Body solver = distributed" + why +
                       "take direct or automatic.");
  }
} // namespace RollingContact
