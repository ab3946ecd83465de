#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/body_parameters.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<ElementKind>> named_elements{
      {"B-bar", ElementKind::b_bar},
      {"enhanced", ElementKind::enhanced}};
    const std::vector<NamedValue<Hub>> named_hubs{{"clamped", Hub::clamped},
                                                  {"free", Hub::free},
                                                  {"elastic", Hub::elastic},
                                                  {"mass", Hub::mass}};

    const std::vector<NamedValue<ModeModel>> named_mode_models{
      {"mesh", ModeModel::mesh},
      {"harmonic", ModeModel::harmonic}},
      named_rail_models{{"mesh", ModeModel::mesh},
                        {"waveguide", ModeModel::waveguide}};

    const std::array<std::string, 3> axes{{"x", "y", "z"}};

    bool hangs_on_axle(const BodyParameters &body)
    {
      return !body.rigid && body.hub == Hub::mass;
    }

    bool has_ends(const BodyParameters &body)
    {
      return body.modes != ModeModel::waveguide;
    }

    bool finds_modes(const SceneParameters &scene)
    {
      return scene.analysis.has_lone_bodies() || scene.analysis.linearises ||
             scene.has_reduced_bodies();
    }

    std::string name_of(const Hub hub)
    {
      for (const NamedValue<Hub> &it : named_hubs)
        if (it.kind == hub)
          return it.name;
      return "";
    }
  } // namespace

  void BodyParameters::declare_hub(Entries &entries)
  {
    entries.choice("Elements", model.elements, named_elements).help =
      "Kind of the linear elements. `B-bar`: for all materials. `enhanced`: "
      "with incompatible modes, which bend well with one or two elements "
      "through a web.";
    entries.choice("Hub", hub, named_hubs).help =
      "How a body is held: a disc at its inner circle, a block at its bottom, "
      "a wheel at its bore, a rail at its foot. `clamped`: it does not move. "
      "`elastic`: on springs, see Foundation stiffness. `free`: by its "
      "inertia alone, in a transient analysis. `mass`: on the rigid mass of "
      "an axle, in a transient analysis and for a wheel that vibrates about a "
      "steady state in which the axle is held.";
    const Reader of_mass =
      reader(hangs_on_axle, "an elastic body with Hub = mass reads it");
    entries.add("Hub mass", model.hub_mass.mass, "kg")
      .at_least(0.)
      .read_by(of_mass)
      .help = "Mass of the rigid axle at the middle of the hub, for Hub = "
              "mass.";
    for (unsigned int c = 0; c < 3; ++c)
      entries.add("Hub inertia " + axes[c], model.hub_mass.inertia[c], "kg m^2")
        .at_least(0.)
        .read_by(c == 1 ? std::vector{of_mass}
                        : std::vector{scenes_in_3d(), of_mass})
        .help = "Moment of inertia of Hub mass about " +
                std::string(c == 1   ? "the axle"
                            : c == 0 ? "x"
                                     : "z") +
                (c == 1 ? "" : ", 3D only") + ".";
  }

  Reader BodyParameters::analyses_of_modes()
  {
    return {finds_modes,
            "it belongs to the modes of a body, and this analysis finds none"};
  }

  std::vector<Reader> BodyParameters::readers_of_damping() const
  {
    return {reader([](const BodyParameters &body) { return !body.rigid; },
                   "a rigid body has no damping"),
            {[](const SceneParameters &scene) {
               return finds_modes(scene) ||
                      (scene.time.inertia && scene.marches());
             },
             "damping acts in Analysis = transient with Time/Inertia = true "
             "and in analyses of modes only"}};
  }

  void BodyParameters::declare_modes(Entries &entries)
  {
    if (section == "Rail")
      {
        entries.choice("Model", modes, named_rail_models)
          .read_by(scenes_in_3d())
          .read_by(analyses_of_modes())
          .help =
          "How a rail vibrates. `mesh`: by the modes of its mesh, which ends "
          "after Block length. `waveguide`: by the waves in its section, "
          "without ends, for extruded rails (section, true sections of "
          "profiles) on a layer or on pads (Hub = elastic). The mesh still "
          "gives the static deformation.";
        return;
      }
    entries.choice("Model", modes, named_mode_models)
      .read_by(scenes_in_3d())
      .read_by(analyses_of_modes())
      .help =
      "Where the modes of a wheel come from. `mesh`: from its elements in "
      "three dimensions. `harmonic`: from cubic elements of its section and "
      "Fourier series about the axle, which are exact to 0.1 % without a fine "
      "mesh; for wheels of revolution (disc, section, true sections of "
      "profiles) whose hub is not elastic.";
  }

  void BodyParameters::check_modes(const BodyShape   *body_shape,
                                   const unsigned int dimension) const
  {
    if (rigid || modes == ModeModel::mesh || dimension == 2)
      return;
    if (modes == ModeModel::waveguide)
      {
        check_waveguide(body_shape);
        return;
      }
    const std::string entry = section + "/Model = harmonic: ";
    if (hub == Hub::elastic)
      throw InputError(
        entry + "its hub must be clamped, free or on an axle, and Hub = " +
        name_of(hub) + "; take Model = mesh.");
    if (body_shape != nullptr && !body_shape->section_about_axle())
      throw InputError(entry +
                       "this is not a body of revolution; take Shape = disc, "
                       "or section with a Radius above 0, or Model = mesh.");
  }

  void BodyParameters::check_waveguide(const BodyShape *body_shape) const
  {
    const std::string entry = section + "/Model = waveguide: ";
    if (hub != Hub::elastic)
      throw InputError(
        entry + "the rail must lie on springs, and Hub = " + name_of(hub) +
        "; take Hub = elastic with its Foundation stiffness, or "
        "Model = mesh.");
    if (body_shape != nullptr && body_shape->extruded_section() == nullptr)
      throw InputError(entry +
                       "this body is not extruded from a section; take Shape "
                       "= section with Radius = 0, Profiles/Body sections = "
                       "true, or Model = mesh.");
  }

  void BodyParameters::declare_damping(Entries &entries)
  {
    BodyDamping              &damping = model.damping;
    const std::vector<Reader> damped  = readers_of_damping();
    entries.add("Loss factor", damping.loss_factor, "1")
      .at_least(0.)
      .read_by(damped)
      .help =
      "Loss factor eta of the material. In the frequency domain the stiffness "
      "is multiplied by 1 + i eta; see Loss frequency.";
    entries.add("Loss frequency", damping.loss_frequency, "Hz")
      .at_least(0.)
      .read_by(damped)
      .read_by({[](const SceneParameters &scene) {
                  return !scene.analysis.has_lone_bodies();
                },
                "in the frequency domain loss factors need no such frequency"})
      .read_by(
        {[is_wheel = section == "Wheel"](const SceneParameters &scene) {
           const BodyParameters &body = is_wheel ? scene.wheel : scene.rail;
           return body.model.damping.loss_factor != 0. || !finds_modes(scene);
         },
         "each mode has the loss factors of its supports at its own "
         "frequency"})
      .read_by(reader(
        [](const BodyParameters &body) {
          const Foundation &foundation = body.model.foundation;
          return body.model.damping.loss_factor != 0. ||
                 foundation.loss_factor != 0. ||
                 foundation.ballast_loss_factor != 0.;
        },
        "all loss factors are 0"))
      .help =
      "Frequency f at which viscous damping, C = eta K / (2 pi f), is as "
      "large as the loss factor eta asks for. Damping is viscous with "
      "Time/Bodies = full, and always for the material under the contact that "
      "the modes leave out. Modes have the loss factors at their own "
      "frequencies.";
    entries.add("Rayleigh mass", damping.mass_damping, "1/s")
      .at_least(0.)
      .read_by(damped)
      .help = "Damping C = this value times M, in addition to that of section "
              "Time.";
    entries.add("Rayleigh stiffness", damping.stiffness_damping, "s")
      .at_least(0.)
      .read_by(damped)
      .help = "Damping C = this value times K, in addition to that of section "
              "Time.";
    const Reader ends =
      reader(has_ends,
             "a rail with Model = waveguide has no ends and no modes");
    entries.list("Modal damping", damping.modal, "", "1")
      .read_by(analyses_of_modes())
      .read_by(ends)
      .help =
      "Damping ratios of modes with 0, 1, 2, ... nodal diameters. The last "
      "one holds for all further modes.";
    entries.add("Sponge length", damping.sponge_length, "m")
      .at_least(0.)
      .read_by(damped)
      .read_by(ends)
      .help =
      "Length of the part at each end of a rail that absorbs waves by damping "
      "C = a(x) M; 0: none.";
    entries.add("Sponge rate", damping.sponge_rate, "1/s")
      .at_least(0.)
      .read_by(damped)
      .read_by(reader(
        [](const BodyParameters &body) {
          return body.model.damping.sponge_length != 0.;
        },
        "there are no absorbing ends, Sponge length = 0"))
      .help =
      "Largest a of the absorbing ends (Sponge length), at the very ends. "
      "Inwards a falls to 0 with the square of the distance.";
  }

  void BodyParameters::check_model(const BodyShape *body_shape) const
  {
    if (rigid && hub != Hub::clamped)
      throw InputError(section + "/Hub = " + name_of(hub) +
                       ": a rigid body is held; take Rigid = false or Hub = "
                       "clamped.");
    if (rigid)
      return;
    if (hub == Hub::mass)
      require(model.hub_mass.mass > 0.,
              "Hub mass",
              model.hub_mass.mass,
              "Hub = mass needs a mass above 0 kg; an axle has some 300 kg. "
              "For a hub without mass take Hub = free.");
    if (hub == Hub::elastic)
      check_foundation(body_shape);
    check_damping(body_shape);
  }

  void BodyParameters::check_foundation(const BodyShape *body_shape) const
  {
    const Foundation &foundation = model.foundation;
    require(foundation.stiffness[2] > 0.,
            "Foundation stiffness z",
            foundation.stiffness[2],
            "Hub = elastic needs one above 0 N/m^2; rails lie on 1e7 to 1e9.");
    if (foundation.pad_spacing > 0.)
      {
        require(foundation.pad_length > 0. &&
                  foundation.pad_length <= foundation.pad_spacing,
                "Pad length",
                foundation.pad_length,
                "it must be above 0 m and at most Pad spacing = " +
                  significant(foundation.pad_spacing, 6) + " m.");
        if (body_shape && !is_from_file())
          check_pads_on(body_shape->reach_x());
      }
    if (!foundation.has_sleepers())
      return;
    require(foundation.pad_spacing > 0.,
            "Sleeper mass",
            foundation.sleeper_mass,
            "sleepers need a Pad spacing above 0 m, some 0.6.");
    require(foundation.ballast_stiffness[2] > 0.,
            "Ballast stiffness z",
            foundation.ballast_stiffness[2],
            "sleepers need one above 0 N/m^2; ballast has some 1e8.");
  }

  void BodyParameters::check_pads_on(const double reach) const
  {
    const Foundation &foundation = model.foundation;
    const double      nearest =
      std::abs(std::remainder(foundation.pad_offset, foundation.pad_spacing));
    require(nearest + foundation.pad_length / 2 <= reach,
            "Pad spacing",
            foundation.pad_spacing,
            "with Pad length = " + significant(foundation.pad_length, 6) +
              " m and Pad offset = " + significant(foundation.pad_offset, 6) +
              " m no pad lies wholly under the body, which reaches " +
              significant(reach, 6) +
              " m to both sides; take a shorter spacing or a longer body.");
  }

  void BodyParameters::check_damping(const BodyShape *body_shape) const
  {
    const BodyDamping &damping = model.damping;
    require(damping.loss_frequency > 0.,
            "Loss frequency",
            damping.loss_frequency,
            "it must be above 0 Hz; take one in the middle of the frequencies "
            "of interest.");
    for (const double ratio : damping.modal)
      require(ratio >= 0. && ratio < 1.,
              "Modal damping",
              ratio,
              "damping ratios are at least 0 and below 1; steel wheels have "
              "1e-4 to 1e-2.");
    if (damping.sponge_length == 0.)
      return;
    const bool is_closed =
      shape == "disc" || (section == "Wheel" && shape != "block");
    require(!is_closed,
            "Sponge length",
            damping.sponge_length,
            "a body that closes on itself has no ends to absorb waves; set it "
            "to 0.");
    if (body_shape)
      require(damping.sponge_length < body_shape->reach_x(),
              "Sponge length",
              damping.sponge_length,
              "it must be shorter than half of the body, " +
                significant(body_shape->reach_x(), 6) + " m.");
  }

  void BodyParameters::check_held(const unsigned int dimension) const
  {
    if (rigid)
      return;
    if (is_loose(hub))
      throw InputError(
        section + "/Hub = " + name_of(hub) +
        ": only inertia holds such a body; take `clamped`, or "
        "Analysis = transient with Time/Inertia = true and "
        "Time/Initial state = rest; a wheel with `mass` may also "
        "vibrate about a steady state, as in Analysis = "
        "stability.");
    if (hub != Hub::elastic)
      return;
    const auto check = [&](const std::string           &layer,
                           const std::array<double, 3> &stiffness) {
      for (unsigned int c = 0; c < 3; ++c)
        if (c != 1 || dimension == 3)
          require(stiffness[c] > 0.,
                  layer + " stiffness " + axes[c],
                  stiffness[c],
                  "nothing holds the body along " + axes[c] +
                    ", and without inertia it must be held: give a stiffness "
                    "in N/m^2.");
    };
    check("Foundation", model.foundation.stiffness);
    if (model.foundation.has_sleepers())
      check("Ballast", model.foundation.ballast_stiffness);
  }
} // namespace RollingContact
