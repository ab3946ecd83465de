#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/tables/table_plan.h>
#include <rolling_contact/wheelset/curve_walk.h>
#include <rolling_contact/wheelset/found_place.h>

namespace RollingContact
{
  namespace
  {
    /// m, of a straight track
    const double straight = 1e9;

    /** The scene with a disc and a block of its materials, which half-spaces
     * stand for. */
    SceneParameters plain_scene(const SceneParameters &scene)
    {
      SceneParameters plain = scene;
      plain.wheel           = BodyParameters("Wheel");
      plain.rail            = BodyParameters("Rail");
      for (const Side side : both_sides)
        {
          BodyParameters &body = side == Side::wheel ? plain.wheel : plain.rail;
          body.rigid           = scene.body(side).rigid;
          body.material        = scene.body(side).material;
          body.width           = 0.1;
        }
      plain.wheel.radius               = scene.wheel.radius;
      plain.wheel.hub_radius           = scene.wheel.radius / 4;
      plain.rail.shape                 = "block";
      plain.rail.radius                = 0.;
      plain.rail.block_length          = 0.3;
      plain.rail.block_depth           = 0.15;
      plain.profiles.true_sections     = false;
      plain.mesh                       = MeshParameters();
      plain.mesh.elements_across_patch = 8;
      return plain;
    }

    /** Profiles that the left-hand side has for itself can be read. */
    void check_left_profiles(const SceneParameters &scene)
    {
      const WheelsetParameters &wheelset = scene.own<WheelsetParameters>();
      if (wheelset.left_wheel_profile.empty() &&
          wheelset.left_rail_profile.empty())
        return;
      try
        {
          const ProfileParameters left = wheelset.left_profiles(scene.profiles);
          left.wheel(scene.prm_folder);
          left.rail(scene.prm_folder);
        }
      catch (const InputError &error)
        {
          throw InputError("Analysis = " + scene.analysis.name +
                           ": Wheelset/Left wheel profile or Left rail "
                           "profile: " +
                           error.what());
        }
    }

    /**
     * Rules for a scene whose wheels are those of a wheelset in balance.
     */
    void check_found_place(const SceneParameters &scene)
    {
      const auto refuse = [&](const std::string &text) {
        throw InputError("Analysis = " + scene.analysis.name + ": " + text);
      };
      if (scene.dimension != 3)
        refuse("the wheels of a wheelset touch their rails on profiles; set "
               "Dimension = 3.");
      const ProfileParameters &profiles = scene.profiles;
      if (!profiles.in_use())
        refuse("the wheelset has no profiles; give Profiles/Wheel profile and "
               "Rail profile.");
      if (profiles.surface_kind != Profiles::SurfaceKind::curved)
        refuse("a wheel may touch on tread and flange at once; set "
               "Profiles/Contact surface = curved.");
      check_left_profiles(scene);
      const ContactParameters &contact = scene.contact;
      if (contact.normal_load || contact.vertical_load || contact.approach)
        refuse("the loads of the wheels follow from Wheelset/Axle load; leave "
               "Contact/Normal load, Vertical load and Approach empty.");
      if (contact.friction_coefficient == 0.)
        refuse("Contact/Friction coefficient = 0: without friction nothing "
               "steers a wheelset; give one above 0.");
      if (contact.rolling_speed() < 0.)
        refuse("it rolls forwards; give a positive Contact/Speed, and the "
               "curve to the other side.");
      if (contact.forces.x || contact.forces.y || contact.forces.moment)
        refuse("creepages are those of its motion; leave the forces of section "
               "Contact empty.");
    }

    void check_wheelset(const SceneParameters &scene)
    {
      check_found_place(scene);
      const auto refuse = [&](const std::string &text) {
        throw InputError("Analysis = " + scene.analysis.name + ": " + text);
      };
      if (scene.profiles.has_true_sections() || scene.wheel.is_from_file() ||
          scene.rail.is_from_file())
        refuse("its many states are solved on bodies that do not know where "
               "they touch; take Profiles/Body sections = plain, a disc and a "
               "block.");
      if (scene.surfaces.in_use())
        refuse("surfaces that pass (section Surfaces) have no steady state; "
               "leave them empty.");
      if (scene.mesh.target_error || scene.mesh.adaptive_levels > 0)
        refuse("its states share bodies; leave Mesh/Target error empty and "
               "Adaptive levels at 0, and give Elements across patch.");
    }

    void check_wheels_found(const SceneParameters &scene)
    {
      if (!scene.finds_place())
        return;
      check_found_place(scene);
      const WheelsetParameters &wheelset = scene.own<WheelsetParameters>();
      if (wheelset.cases().size() > 1)
        throw InputError(
          "Wheelset/Curve radius has several values and Analysis = " +
          scene.analysis.name +
          ": it disturbs the state of one curve; give one radius, or an axis "
          "Wheelset/Curve radius of a stability map.");
      if (wheelset.is_bogie)
        throw InputError(
          "Wheelset/Vehicle = bogie and Analysis = " + scene.analysis.name +
          ": it disturbs wheels of one wheelset; run the bogie with Analysis = "
          "wheelset and give Half wheelbase, Frame yaw and Lateral force of "
          "one of its wheelsets from wheelset.csv.");
      if (scene.stability.wheels != WheelsFound::both)
        return;
      if (!wheelset.left_wheel_profile.empty() ||
          !wheelset.left_rail_profile.empty() || wheelset.left_wheel_radius)
        throw InputError(
          "Stability/Wheel = both: wheels that are disturbed together are "
          "alike; give left or right where the left-hand side has profiles or "
          "a radius of its own (section Wheelset).");
      if (scene.analysis.has_many_states && scene.table.file_of_rows.empty())
        throw InputError("Stability/Wheel = both: a grid has one wheel; give "
                         "left or right, or states by Table/File of rows.");
    }
  } // namespace

  SceneRules rules_of_wheelsets()
  {
    return {&check_wheelset};
  }

  SceneCondition has_bogie()
  {
    return [](const SceneParameters &scene) {
      return scene.own<WheelsetParameters>().is_bogie;
    };
  }

  SceneRules rules_of_disturbed_wheels()
  {
    return {&check_wheels_found};
  }

  FoundEquilibrium equilibrium_on_half_spaces(const Situation &scene)
  {
    const WheelsetParameters &asked = scene.inputs->own<WheelsetParameters>();
    const bool                is_mirrored = asked.goes_to_the_left();
    const WheelsetParameters  wheelset = is_mirrored ? asked.mirrored() : asked;
    const Situation           plain(plain_scene(*scene.inputs));
    RunningGear               gear(plain, wheelset, true);
    if (is_mirrored)
      gear.swap_sides();
    CurveWalk walk(gear);
    walk.begin();
    walk.go_to(wheelset.cases().front());
    gear.polish();
    FoundEquilibrium found;
    found.state = gear.now().wheelsets[0];
    found.roll  = gear.wheels(0).roll(found.state.place);
    if (is_mirrored)
      {
        found.state = found.state.mirrored();
        found.roll  = -found.roll;
      }
    found.n_steps  = gear.n_steps();
    found.n_states = gear.n_states();
    found.n_bodies = gear.n_bodies();
    return found;
  }

  std::vector<std::pair<std::string, double>>
  placing_entries(const Situation        &scene,
                  const FoundEquilibrium &found,
                  const unsigned int      wheel)
  {
    const WheelsetState &state     = found.state;
    const double         curvature = state.acting.curvature;
    return {{"Profiles/Lateral shift", state.place.on_rail(wheel)},
            {"Profiles/Yaw", state.place.yaw},
            {"Profiles/Roll", found.roll},
            {"Profiles/Pitch rate",
             state.place.pitch_rate(scene.contact.rolling_speed(),
                                    scene.wheel.radius)},
            {"Profiles/Curve radius",
             curvature == 0. ? straight : 1 / curvature},
            {"Contact/Vertical load", state.wheels[wheel].load}};
  }

  Situation scene_of_wheel(const Situation        &scene,
                           const FoundEquilibrium &found,
                           const unsigned int      wheel)
  {
    const WheelsetParameters &wheelset =
      scene.inputs->own<WheelsetParameters>();
    SceneEntries entries(scene);
    entries.set("Stability/Wheel", "none");
    entries.set("Profiles/Side", wheel == 1 ? "left" : "right");
    entries.set("Profiles/Creepages", "from kinematics");
    entries.set("Profiles/Lateral velocity", "0");
    for (const auto &[entry, value] : placing_entries(scene, found, wheel))
      entries.set(entry, exact_text(value));
    if (wheel == 1)
      {
        const ProfileParameters left = wheelset.left_profiles(scene.profiles);
        entries.set("Profiles/Wheel profile", left.wheel_profile);
        entries.set("Profiles/Rail profile", left.rail_profile);
        if (wheelset.left_wheel_radius)
          entries.set("Wheel/Radius", exact_text(*wheelset.left_wheel_radius));
      }
    return entries.situation();
  }
} // namespace RollingContact
