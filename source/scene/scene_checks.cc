#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/surfaces/crown.h>

#include <cmath>

namespace RollingContact
{
  void SceneParameters::check_hubs() const
  {
    const bool dynamic       = marches() && time.inertia;
    const bool hangs_on_axle = moves_axle();
    if (!dynamic || time.initial_state == InitialState::steady)
      for (const BodyParameters *body : {&wheel, &rail})
        if (body != &wheel || !hangs_on_axle)
          body->check_held(dimension);
    if (hangs_on_axle && !wheel.dampers.number.empty())
      throw InputError("Wheel/Dampers and Wheel/Hub = mass: dampers are known "
                       "on a wheel whose hub is held; take Hub = clamped, or "
                       "leave Dampers empty.");
    const bool free_wheel =
      !wheel.rigid && is_loose(wheel.hub) && !hangs_on_axle;
    if (free_wheel && contact.normal_load)
      throw InputError(
        "Contact/Normal load = " + text_of(*contact.normal_load) +
        " and Wheel/Hub = " + (wheel.hub == Hub::free ? "free" : "mass") +
        ": the load acts through a hub that is held; give Contact/Approach "
        "instead.");
    if (time.initial_velocity != 0. && !free_wheel)
      throw InputError(
        "Time/Initial velocity = " + text_of(time.initial_velocity) +
        ": it is that of an elastic wheel with Wheel/Hub = "
        "free or mass.");
  }

  void SceneParameters::check_hot_friction() const
  {
    const std::string &hot = contact.friction_over_temperature;
    if (hot.empty() || contact.friction_coefficient == 0.)
      return;
    const std::string given = "Contact/Friction over temperature = " + hot;
    if (marches() || analysis.linearises)
      throw InputError(given + ": Analysis = " + analysis.name +
                       " cannot follow the temperature of vibrating surfaces; "
                       "leave it empty, or find the steady state "
                       "with Analysis = quasi-static.");
    if (!contact.speed)
      throw InputError(given +
                       " and Contact/Speed is empty: how hot friction makes "
                       "the surfaces depends on the rolling speed V in m/s; "
                       "give it.");
  }

  void SceneParameters::check_speed() const
  {
    if (contact.speed || !contact.falling_friction() ||
        (marches() && !time.speed.empty()))
      return;
    throw InputError("Contact/Friction law = " + contact.friction_law +
                     " and Contact/Speed is empty: friction falls with the "
                     "sliding speed |s| V, give the rolling speed V in m/s" +
                     (marches() ? ", here or as Time/Speed." : "."));
  }

  void SceneParameters::check_mesh_files() const
  {
    for (const BodyParameters *body : {&wheel, &rail})
      {
        if (!body->is_from_file())
          continue;
        const bool        section = body->is_section();
        const std::string why =
          section ? ": a body with a section from a file (" + body->section +
                      "/Shape) "
                  : ": a body from a mesh file (" + body->section + "/Shape) ";
        const std::string not_refined =
          section ? "is refined for the estimated patch only; set it to 0."
                  : "is not refined; set it to 0.";
        if (body_solver == BodySolver::distributed)
          throw InputError("Body solver = distributed" + why +
                           "lives on one rank; take direct or automatic.");
        if (mesh.adaptive_levels > 0)
          throw InputError(
            "Mesh/Adaptive levels = " + std::to_string(mesh.adaptive_levels) +
            why + not_refined);
        if (mesh.rim_levels > 0)
          throw InputError("Mesh/Rim levels = " +
                           std::to_string(mesh.rim_levels) + why + not_refined);
      }
  }

  void SceneParameters::check_forces(const std::string &asked,
                                     const bool         across) const
  {
    if (across && profiles.in_use() &&
        profiles.surface_kind == Profiles::SurfaceKind::curved)
      throw InputError("Profiles/Contact surface = curved and a Lateral force "
                       "or Spin moment: pressure contributes to both there, "
                       "so that the part of friction cannot be given. Give "
                       "Longitudinal force only, creepages, or Contact "
                       "surface = plane.");
    if (mesh.adaptive_levels > 0)
      throw InputError(
        asked +
        " and Mesh/Adaptive levels = " + std::to_string(mesh.adaptive_levels) +
        ": levels end when the forces no longer change, and here the forces "
        "are given. Set the levels to 0, or give creepages.");
  }

  void SceneParameters::check_target_error() const
  {
    if (!mesh.target_error || marches())
      return;
    const std::string target =
      "Mesh/Target error = " + text_of(*mesh.target_error);
    if (surfaces.in_use() || names_a_record(contact.roughness))
      throw InputError(
        target +
        ": the error of surfaces that move (section Surfaces) or come from a "
        "file is not known beforehand. Leave it empty and give Mesh/Elements "
        "across patch.");
    if (analysis.has_own_meshes)
      return;
    if (contact.friction_coefficient <= 0.)
      throw InputError(
        target + " and Contact/Friction coefficient = 0: it is an error of "
                 "the friction force. Leave it empty and give Mesh/Elements "
                 "across patch.");
    if (mesh.adaptive_levels > 0)
      throw InputError(
        target +
        " and Mesh/Adaptive levels = " + std::to_string(mesh.adaptive_levels) +
        ": the target chooses one mesh, levels refine it. Leave the target "
        "empty, or set the levels to 0.");
    for (const BodyParameters *body : {&wheel, &rail})
      if (body->is_from_file())
        throw InputError(target + ": a body from a mesh file (" +
                         body->section +
                         "/Shape) has elements of its own, whose error is not "
                         "known. Leave it empty.");
  }

  void SceneParameters::check_pair() const
  {
    if (wheel.rigid && rail.rigid)
      throw InputError("Wheel/Rigid = true and Rail/Rigid = true: at least one "
                       "body must be elastic.");
    if (dimension == 2 && !wheel.rigid && !rail.rigid &&
        wheel.thickness != rail.thickness)
      throw InputError("Wheel/Thickness = " + text_of(wheel.thickness) +
                       " and Rail/Thickness = " + text_of(rail.thickness) +
                       ": plane strain needs the same thickness in both.");
  }

  void SceneParameters::check_covers() const
  {
    const BodyParameters &body = wheel.has_cover() ? wheel : rail;
    if (!body.has_cover())
      return;
    const std::string given =
      body.section + "/Cover thickness = " + text_of(body.cover_thickness);
    const auto refuse = [](const bool is_given, const std::string &why) {
      if (is_given)
        throw InputError(why);
    };
    refuse(!analysis.has_bodies || !analysis.has_contact ||
             analysis.linearises || analysis.has_own_meshes ||
             analysis.has_row_for_each_run() || analysis.wears_profiles,
           given +
             ": Analysis = quasi-static, creep curve, load curve, table "
             "and transient take covers; for " +
             analysis.name + " set it to 0 m.");
    refuse(has_reduced_bodies(),
           given + ": Time/Bodies = reduced has modes of one material; take "
                   "full, or set it to 0 m.");
    refuse(profiles.in_use(),
           given + ": bodies with profiles have no covers; leave "
                   "Profiles/Wheel profile and Rail profile empty, or set it "
                   "to 0 m.");
    refuse(
      body_solver == BodySolver::distributed,
      "Body solver = distributed and " + given +
        ": conjugate gradients with multigrid converge slowly where a soft "
        "layer lies on a stiff body; take Body solver = direct.");
    refuse(mesh.compliance == Compliance::split,
           "Mesh/Compliance = split and " + given +
             ": half-spaces have no covers; take finite elements.");
    refuse(mesh.adaptive_levels > 0,
           "Mesh/Adaptive levels = " + std::to_string(mesh.adaptive_levels) +
             " and " + given +
             ": levels are judged by jumps of stresses, which covers have by "
             "themselves; set the levels to 0.");
    refuse(!!mesh.target_error,
           "Mesh/Target error and " + given +
             ": no bound of the error is known with covers; leave it empty and "
             "give Mesh/Elements across patch.");
    for (const Side side : both_sides)
      refuse(!!crown_named(SurfaceParameters::entry(side),
                           surfaces.height[side]),
             SurfaceParameters::entry(side) + " = " + surfaces.height[side] +
               " and " + given +
               ": named crowns are those of half-spaces; give the drop as an "
               "expression in y.");
  }

  void SceneParameters::check_body_solver() const
  {
    if (body_solver != BodySolver::distributed)
      return;
    for (const BodyParameters *body : {&wheel, &rail})
      if (!body->rigid &&
          body->material.poisson_ratio > distributed_poisson_limit)
        throw InputError(
          body->section +
          "/Poisson ratio = " + text_of(body->material.poisson_ratio) +
          ": conjugate gradients with multigrid converge up to " +
          text_of(distributed_poisson_limit) + "; take Body solver = direct.");
  }

  void SceneParameters::check_profiles_on_files(const std::string &given) const
  {
    for (const BodyParameters *body : {&wheel, &rail})
      {
        if (!body->is_from_file())
          continue;
        if (!body->is_section())
          throw InputError(given + "a body from a mesh file (" + body->section +
                           "/Shape) brings its own surface; leave the profiles "
                           "empty, or take Shape = section.");
        if (profiles.true_sections)
          throw InputError(body->section + "/Shape = section and "
                                           "Profiles/Body sections = true: the "
                                           "section is that of the file; take "
                                           "Body sections = plain.");
        if (body->surface != SurfaceSource::radii)
          throw InputError(body->section +
                           "/Surface = nodes: the undeformed surface is that "
                           "of Profiles/" +
                           body->section +
                           " profile; take radii, the default.");
      }
  }

  void SceneParameters::check_profiles() const
  {
    if (contact.vertical_load && !profiles.in_use())
      throw InputError(
        "Contact/Vertical load = " + text_of(*contact.vertical_load) +
        ": without profiles the vertical is the normal; give "
        "Contact/Normal load.");
    if (!profiles.in_use())
      return;
    const std::string given =
      "Profiles/Wheel profile = " + profiles.wheel_profile +
      ", Profiles/Rail profile = " + profiles.rail_profile + ": ";
    if (profiles.wheel_profile.empty() || profiles.rail_profile.empty())
      throw InputError(given + "give both or none of them.");
    if (dimension == 2)
      throw InputError(given + "profiles are across the track, take "
                               "Dimension = 3.");
    check_profiles_on_files(given);
    if (!rail.rigid && ((rail.shape != "block" && rail.shape != "section") ||
                        rail.radius != 0.))
      throw InputError("Rail/Shape = " + rail.shape +
                       ", Rail/Radius = " + text_of(rail.radius) +
                       ": a rail with a profile is straight; take Rail/Shape "
                       "= block or section and Rail/Radius = 0.");
    if (profiles.true_sections && !wheel.rigid && wheel.shape != "disc")
      throw InputError("Wheel/Shape = " + wheel.shape +
                       " and Profiles/Body sections = true: the wheel is a "
                       "body of revolution then; take Wheel/Shape = disc.");
    if (profiles.true_sections && !rail.rigid &&
        !profiles.has_section_of_60e1())
      throw InputError("Profiles/Rail profile = " + profiles.rail_profile +
                       " and Profiles/Body sections = true: web and foot of "
                       "true sections are those of a 60E1; take Body sections "
                       "= plain, or a section from a file (Rail/Shape = "
                       "section).");
    for (const BodyParameters *body : {&wheel, &rail})
      if (body->lateral_radius != 0.)
        throw InputError(body->section +
                         "/Lateral radius = " + text_of(body->lateral_radius) +
                         ": the surface across the track is that of Profiles/" +
                         body->section + " profile; set it to 0 m.");
    if (contact.vertical_load && marches())
      throw InputError(
        "Contact/Vertical load = " + text_of(*contact.vertical_load) +
        ": in time the load is along the normal; give "
        "Contact/Normal load.");
    if (profiles.surface_kind == Profiles::SurfaceKind::curved && marches() &&
        (contact.normal_load || !time.normal_load.empty()) &&
        !time.hold_approach)
      throw InputError(
        "Profiles/Contact surface = curved: friction carries a part of the "
        "load there, which in time is not followed; give Contact/Approach, or "
        "hold that of the load (Time/Hold approach = true).");
    profiles.check(wheel.radius, prm_folder);
  }

  namespace
  {
    /** A crown has the length of the line that it is for. */
    void check_crowns(const SceneParameters &scene)
    {
      for (const Side side : both_sides)
        if (const std::string entry = SurfaceParameters::entry(side);
            !touch_in_line(
              scene.dimension, scene.profiles, scene.wheel, scene.rail) &&
            crown_named(entry, scene.surfaces.height[side]))
          throw InputError(
            entry + " = " + scene.surfaces.height[side] +
            ": a crown is for bodies that touch from side to side; set "
            "Wheel/Lateral radius and Rail/Lateral radius to 0 m without "
            "profiles, or give an expression in y.");
    }

    /**
     * Surfaces that are straight across touch up to the side of a body, which
     * discs and blocks have, in states that are steady.
     */
    void check_line_contact(const SceneParameters &scene)
    {
      const AnalysisTraits &analysis = scene.analysis;
      if (!analysis.has_bodies || !analysis.has_contact)
        return;
      const std::string given =
        "Wheel/Lateral radius = 0 and Rail/Lateral radius = 0: both surfaces are "
        "straight across and touch up to the sides of the bodies. ";
      for (const BodyParameters *body : {&scene.wheel, &scene.rail})
        if (!body->rigid && body->shape != "disc" && body->shape != "block")
          throw InputError(given +
                           "The ends of such a contact are known on "
                           "discs and blocks; " +
                           body->section + "/Shape = " + body->shape +
                           " takes a Lateral radius, or profiles.");
      if (analysis.marches || analysis.linearises || analysis.has_own_meshes ||
          analysis.has_many_states)
        throw InputError(given +
                         "Analysis = quasi-static, creep curve and load curve "
                         "take that; for " +
                         analysis.name +
                         " give a Lateral radius, so that the patch ends "
                         "before the sides.");
      if (scene.mesh.adaptive_levels > 0)
        throw InputError(given + "Mesh/Adaptive levels = " +
                         std::to_string(scene.mesh.adaptive_levels) +
                         " refines no line contact; take 0, and Mesh/Rim "
                         "levels for its ends.");
      if (scene.mesh.target_error)
        throw InputError(
          given + "Mesh/Target error = " + text_of(*scene.mesh.target_error) +
          ": no bound of the error is known there; leave it empty and give "
          "Mesh/Elements across patch.");
    }
  } // namespace

  void SceneParameters::check_curvatures() const
  {
    check_crowns(*this);
    if (profiles.in_use())
      return;
    const auto curvature = [](const double radius) {
      return radius == 0. ? 0. : 1 / radius;
    };
    if (touch_in_line(dimension, profiles, wheel, rail))
      check_line_contact(*this);
    else if (dimension == 3 &&
             curvature(wheel.lateral_radius) + curvature(rail.lateral_radius) <=
               0.)
      throw InputError(
        "Wheel/Lateral radius = " + text_of(wheel.lateral_radius) +
        " and Rail/Lateral radius = " + text_of(rail.lateral_radius) +
        ": the patch would reach the edges of the bodies; the profiles must "
        "curve away from each other across, 1/R_wheel + 1/R_rail > 0.");
    if (curvature(wheel.radius) + curvature(rail.radius) <= 0.)
      throw InputError("Wheel/Radius = " + text_of(wheel.radius) +
                       " and Rail/Radius = " + text_of(rail.radius) +
                       ": the profiles must curve away from each other, "
                       "1/R_wheel + 1/R_rail > 0.");
  }
} // namespace RollingContact
