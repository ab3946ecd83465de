#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/body_parameters.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    const std::vector<NamedValue<ElementKind>> named_elements{
      {"B-bar", ElementKind::b_bar},
      {"enhanced", ElementKind::enhanced}};
    const std::vector<NamedValue<Hub>> named_hubs{{"clamped", Hub::clamped},
                                                  {"free", Hub::free},
                                                  {"elastic", Hub::elastic},
                                                  {"mass", Hub::mass}};

    const std::array<std::string, 3> axes{{"x", "y", "z"}};

    std::string
    name_of(const Hub hub)
    {
      for (const NamedValue<Hub> &it : named_hubs)
        if (it.kind == hub)
          return it.name;
      return "";
    }
  } // namespace



  void
  BodyParameters::declare_hub(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    declare_choice(prm,
                   "Elements",
                   model.elements,
                   named_elements,
                   "Linear elements: `B-bar`, for all materials, or `enhanced` "
                   "by incompatible modes, which bend with one or two through "
                   "a web.");
    declare_choice(prm,
                   "Hub",
                   hub,
                   named_hubs,
                   "What the inner circle of a disc, the bottom of a block, "
                   "the bore of a wheel or the foot of a rail does: `clamped`; "
                   "`elastic`, on the springs of Foundation stiffness; and in "
                   "a transient analysis, where inertia alone holds the body, "
                   "`free`, or `mass`, fixed to the rigid mass of an axle.");
    prm.add_parameter("Hub mass",
                      model.hub_mass.mass,
                      "Rigid mass of Hub = mass, at the middle of the hub. "
                      "Units: kg.",
                      not_negative);
    for (unsigned int c = 0; c < 3; ++c)
      prm.add_parameter("Hub inertia " + axes[c],
                        model.hub_mass.inertia[c],
                        "Moment of inertia of Hub mass about " +
                          std::string(c == 1   ? "the axle"
                                      : c == 0 ? "x"
                                               : "z") +
                          (c == 1 ? "" : ", 3D only") + ". Units: kg m^2.",
                        not_negative);
  }



  void
  BodyParameters::declare_foundation(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    Foundation            &foundation = model.foundation;
    for (unsigned int c = 0; c < 3; ++c)
      prm.add_parameter(
        "Foundation stiffness " + axes[c],
        foundation.stiffness[c],
        "Of the layer or the pads of Hub = elastic along " + axes[c] +
          (c == 1 ? ", 3D only" : "") +
          ": force per displacement of a metre of length along x, spread "
          "evenly over the hub. Units: N/m^2.",
        not_negative);
    prm.add_parameter("Foundation loss factor",
                      foundation.loss_factor,
                      "Of the layer or the pads of Hub = elastic; see Loss "
                      "frequency. Units: 1.",
                      not_negative);
    prm.add_parameter(
      "Pad spacing",
      foundation.pad_spacing,
      "Distance of pads, which then stand for the layer: one has Foundation "
      "stiffness times this. 0 is a continuous layer. Units: m.",
      not_negative);
    prm.add_parameter("Pad length",
                      foundation.pad_length,
                      "Of each pad along x. Units: m.",
                      not_negative);
    prm.add_parameter("Pad offset",
                      foundation.pad_offset,
                      "x of the middle of a pad: 0 has one under the contact, "
                      "half of Pad spacing none. Units: m.",
                      Patterns::Double());
    prm.add_parameter("Sleeper mass",
                      foundation.sleeper_mass,
                      "Mass of a sleeper below each pad, which moves without "
                      "turning; 0 for pads on the ground. Units: kg.",
                      not_negative);
    for (unsigned int c = 0; c < 3; ++c)
      prm.add_parameter("Ballast stiffness " + axes[c],
                        foundation.ballast_stiffness[c],
                        "Between sleepers and ground along " + axes[c] +
                          (c == 1 ? ", 3D only" : "") +
                          ", of a metre of length as Foundation stiffness. "
                          "Units: N/m^2.",
                        not_negative);
    prm.add_parameter("Ballast loss factor",
                      foundation.ballast_loss_factor,
                      "Of the ballast under sleepers; see Loss frequency. "
                      "Units: 1.",
                      not_negative);
  }



  void
  BodyParameters::declare_damping(ParameterHandler &prm)
  {
    const Patterns::Double not_negative(0.);
    BodyDamping           &damping = model.damping;
    prm.add_parameter("Loss factor",
                      damping.loss_factor,
                      "Of the material: stiffness times 1 + i times this in "
                      "the frequency domain; see Loss frequency. Units: 1.",
                      not_negative);
    prm.add_parameter("Loss frequency",
                      damping.loss_frequency,
                      "In time loss factors are viscous, C = eta K / (2 pi f), "
                      "as large as at this frequency f. Units: Hz.",
                      not_negative);
    prm.add_parameter("Rayleigh mass",
                      damping.mass_damping,
                      "Damping C = this times M, beside that of section Time. "
                      "Units: 1/s.",
                      not_negative);
    prm.add_parameter("Rayleigh stiffness",
                      damping.stiffness_damping,
                      "Damping C = this times K, beside that of section Time. "
                      "Units: s.",
                      not_negative);
    declare_number_list(prm,
                        section + "/Modal damping",
                        damping.modal,
                        "",
                        "Damping ratios of modes with 0, 1, 2, ... nodal "
                        "diameters, of all further ones the last. Units: 1.");
    prm.add_parameter("Sponge length",
                      damping.sponge_length,
                      "Of the part at each end of a rail that absorbs waves, "
                      "C = a(x) M; 0 for none. Units: m.",
                      not_negative);
    prm.add_parameter("Sponge rate",
                      damping.sponge_rate,
                      "Largest a, at the very ends; inwards it falls to 0 with "
                      "the square of the distance. Units: 1/s.",
                      not_negative);
  }



  void
  BodyParameters::check_model() const
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
              "Hub = mass needs one above 0 kg; an axle has some 300, a hub "
              "without is Hub = free.");
    if (hub == Hub::elastic)
      check_foundation();
    check_damping();
  }



  void
  BodyParameters::check_foundation() const
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
        if (!is_from_file())
          check_pads_on(body_shape()->reach_x());
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



  void
  BodyParameters::check_pads_on(const double reach) const
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



  void
  BodyParameters::check_damping() const
  {
    const BodyDamping &damping = model.damping;
    require(damping.loss_frequency > 0.,
            "Loss frequency",
            damping.loss_frequency,
            "it must be above 0 Hz; take one amid those of interest.");
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
    if (!is_from_file() || mesh)
      require(damping.sponge_length < body_shape()->reach_x(),
              "Sponge length",
              damping.sponge_length,
              "it must be shorter than half of the body, " +
                significant(body_shape()->reach_x(), 6) + " m.");
  }



  void
  BodyParameters::check_held(const unsigned int dimension) const
  {
    if (rigid)
      return;
    if (is_loose(hub))
      throw InputError(section + "/Hub = " + name_of(hub) +
                       ": only inertia holds such a body; take Analysis = "
                       "transient with Time/Inertia = true and Time/Initial "
                       "state = rest, or `clamped`.");
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
                    ", which only inertia can do without: give it in N/m^2.");
    };
    check("Foundation", model.foundation.stiffness);
    if (model.foundation.has_sleepers())
      check("Ballast", model.foundation.ballast_stiffness);
  }
} // namespace RollingContact
