#include <rolling_contact/analyses/scene_parameters.h>
#include <rolling_contact/base/exceptions.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  SceneParameters::SceneParameters()
    : ParameterAcceptor("/")
    , wheel("Wheel")
    , rail("Rail")
  {
    add_parameter("Dimension",
                  dimension,
                  "2 (x, z: rolling direction and normal, plane strain) or 3. "
                  "Units: 1.",
                  prm,
                  Patterns::Integer(2, 3));
    add_parameter(
      "Analysis",
      analysis,
      "`quasi-static`: one steady rolling state; `creep curve`: many creepages, "
      "see section Creep curve; `transient`: rolling in time, see section "
      "Time; `accuracy study`: the same state on many meshes, or the same "
      "transient with many steps, see section Accuracy study.",
      prm,
      Patterns::Selection("quasi-static|creep curve|transient|accuracy study"));
    add_parameter("Body threads",
                  body_threads,
                  "2: wheel and rail at the same time; 1: one after the other, "
                  "with the same numbers. Units: 1.",
                  prm,
                  Patterns::Integer(1, 2));
  }



  void
  SceneParameters::check_hubs() const
  {
    const bool dynamic = is_transient() && time.inertia;
    for (const BodyParameters *body : {&wheel, &rail})
      if (!body->rigid && body->hub == "free" &&
          (!dynamic || time.initial_state == "steady"))
        throw InputError(body->section +
                         "/Hub = free: only inertia holds such a body; take "
                         "Analysis = transient with Time/Inertia = true and "
                         "Time/Initial state = rest, or `clamped`.");
    const bool free_wheel = !wheel.rigid && wheel.hub == "free";
    if (free_wheel && contact.normal_load())
      throw InputError("Contact/Normal load = " + contact.normal_load_entry +
                       " and Wheel/Hub = free: the load acts through a clamped "
                       "hub; give Contact/Approach instead.");
    if (time.initial_velocity != 0. && !free_wheel)
      throw InputError("Time/Initial velocity = " +
                       Patterns::Tools::to_string(time.initial_velocity) +
                       ": it is that of an elastic wheel with Wheel/Hub = "
                       "free.");
  }



  void
  SceneParameters::check() const
  {
    wheel.check(dimension);
    rail.check(dimension);
    contact.check(dimension);
    mesh.check();
    if (analysis == "accuracy study")
      study.check(dimension);
    creep_curve.check();
    check_hubs();
    if (is_transient())
      time.check(contact, dimension, prm_folder);
    if (wheel.rigid && rail.rigid)
      throw InputError("Wheel/Rigid = true and Rail/Rigid = true: at least one "
                       "body must be elastic.");
    if (dimension == 2 && !wheel.rigid && !rail.rigid &&
        wheel.thickness != rail.thickness)
      throw InputError(
        "Wheel/Thickness = " + Patterns::Tools::to_string(wheel.thickness) +
        " and Rail/Thickness = " + Patterns::Tools::to_string(rail.thickness) +
        ": plane strain needs the same thickness in both.");
    if (analysis == "accuracy study" && mesh.adaptive_levels > 0)
      throw InputError(
        "Mesh/Adaptive levels = " + std::to_string(mesh.adaptive_levels) +
        ": an accuracy study has its own meshes (Accuracy study/Elements "
        "across patch); set it to 0.");
    const auto curvature = [](const double radius) {
      return radius == 0. ? 0. : 1 / radius;
    };
    if (dimension == 3 &&
        curvature(wheel.lateral_radius) + curvature(rail.lateral_radius) <= 0.)
      throw InputError(
        "Wheel/Lateral radius = " +
        Patterns::Tools::to_string(wheel.lateral_radius) +
        " and Rail/Lateral radius = " +
        Patterns::Tools::to_string(rail.lateral_radius) +
        ": the patch would reach the edges of the bodies; the profiles must "
        "curve away from each other across, 1/R_wheel + 1/R_rail > 0.");
    if (curvature(wheel.radius) + curvature(rail.radius) <= 0.)
      throw InputError(
        "Wheel/Radius = " + Patterns::Tools::to_string(wheel.radius) +
        " and Rail/Radius = " + Patterns::Tools::to_string(rail.radius) +
        ": the profiles must curve away from each other, "
        "1/R_wheel + 1/R_rail > 0.");
  }
} // namespace RollingContact
