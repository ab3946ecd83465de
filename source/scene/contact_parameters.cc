#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/contact_parameters.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/hot_friction.h>
#include <rolling_contact/scene/mesh_parameters.h>
#include <rolling_contact/scene/profile_parameters.h>
#include <rolling_contact/scene/study_parameters.h>
#include <rolling_contact/surfaces/roughness.h>

#include <cmath>
#include <tuple>

namespace RollingContact
{
  namespace
  {
    /** Where section Contact gives the creepages. */
    const std::vector<Reader> read_creepages{
      {asks<ProfileParameters>(
         [](const auto &profiles) { return !profiles.gives_creepages(); }),
       "Profiles/Creepages = from kinematics gives them"},
      {&place_is_given,
       "the analysis finds the motion of the wheelset and "
       "with it the creepages"},
      {asks<AnalysisTraits, MeshParameters>(
         [](const auto &analysis, const auto &mesh) { // levels refine for them
           return !analysis.own_creepages || mesh.adaptive_levels > 0;
         }),
       "the creepages of a curve are those of section Creep curve"},
      {asks<AnalysisTraits, StudyParameters>(
         [](const auto &analysis, const auto &study) {
           return !analysis.has_own_meshes || study.varies_time_step;
         }),
       "the creepages of a study are Accuracy study/Creepages over "
       "saturation"}};

    /** Where it gives the forces. */
    const Reader read_forces{
      asks<AnalysisTraits>(
        [](const auto &analysis) { return !analysis.own_creepages; }),
      "the forces of a curve are those of section Creep curve"};
  } // namespace

  void ContactParameters::declare(Entries &entries)
  {
    EntrySection &section = entries.section("Contact");
    section.read_by(analyses_with_elements());
    section.renews = Renews::loads;
    section.varies = in_all_scenes;
    declare_load(entries);
    declare_friction(entries);
    declare_rolling(entries);
  }

  void ContactParameters::declare_load(Entries &entries)
  {
    entries.add("Normal load", normal_load, "N").renewing(Renews::patch).help =
      "Force that presses the wheel on the rail; the approach follows from "
      "it. Give this, `Vertical load` or `Approach`.";
    entries.add("Vertical load", vertical_load, "N")
      .renewing(Renews::patch)
      .help =
      "Vertical force of the rail on the wheel. Where profiles touch at an "
      "angle, the normal load and friction carry it together.";
    entries.add("Approach", approach, "m").renewing(Renews::patch).help =
      "Displacement of the wheel's hub towards the rail, counted from first "
      "touch; the load follows from it.";
    entries.choice("Slip operator", slip_operator, slip_operator_choices())
      .renewing(Renews::bodies)
      .help = "Discretisation of the slip operator B1. " +
              choice_help(slip_operator_choices());
    entries
      .choice("Contact matrices", contact_matrices, contact_matrices_choices())
      .help = "How the contact matrices H_n and H_t are computed. " +
              choice_help(contact_matrices_choices());
    entries.add("Roughness", roughness, "m").help =
      "Roughness that stays where it is while the material flows. An "
      "expression in x and y (m) such as 2e-6*cos(2*pi*x/1e-3), with pi and "
      "the functions of the histories in section Time, is added to the gap of "
      "the smooth profiles. Heights in a file point out of a body and are "
      "subtracted from the gap: " +
      std::string(kinds_of_surface_files) +
      ", in units of section Surfaces, with its positions along x. Empty for "
      "none.";
  }

  void ContactParameters::declare_friction(Entries &entries)
  {
    entries.add("Friction coefficient", friction_coefficient, "1")
      .at_least(0.)
      .help =
      "Coulomb's mu; with a Friction law other than `constant` the static "
      "mu_s. 0: no friction.";
    entries.add("Friction law", friction_law)
      .one_of(choice_names(friction_law_kinds()))
      .help =
      "How mu changes with the sliding speed v = |s| V, from mu_s at rest to "
      "mu_k: mu falls, or rises where mu_k is above mu_s. " +
      choice_help(friction_law_kinds());
    entries.add("Kinetic friction coefficient", kinetic_friction, "1")
      .at_least(0.)
      .help =
      "mu_k, which mu approaches at high sliding speed, of a Friction law "
      "other than `constant`. Polach: 0.4 mu_s, dry. Above mu_s friction "
      "rises, as with a friction modifier.";
    entries.add("Friction decay speed", friction_decay_speed, "m/s")
      .at_least(0.)
      .help = "v_c, the sliding speed over which mu changes, of a Friction "
              "law other than `constant`. Polach: 1/0.6 m/s, dry.";
    entries.add("Friction memory length", friction_memory_length, "m")
      .at_least(0.)
      .help =
      "Distance that a point of the material slides until its mu has followed "
      "the Friction law; some micrometres. 0: mu follows at once.";
    entries.add("Friction response", friction_response)
      .one_of("automatic|patch mean|node|constant")
      .help =
      "How mu follows the sliding speed when the state changes in time or is "
      "disturbed, with a Friction law other than `constant`. `patch mean`: mu "
      "of all nodes follows the mean speed of the patch with a delay; `node`: "
      "mu of each node follows its own speed at once, which is ill-posed "
      "where friction falls; `constant`: mu does not follow; `automatic`: "
      "patch mean where vibrations are analysed (Analysis = stability and "
      "others) and with Time/Bodies = reduced, else node.";
    entries.add("Friction memory", friction_memory, "s").at_least(0.).help =
      "Delay of Friction response = `patch mean`. A time step may be at most "
      "a tenth of it.";
    entries.add("Friction over temperature", friction_over_temperature).help =
      "How mu depends on the temperature of the surfaces in a steady state: "
      "temperatures in K, each with the share of mu there, such as 293: 1, "
      "573: 1, 1073: 0.5; linear in between. Empty: mu does not depend on it. "
      "The temperature follows from `Temperature` of `Wheel` and `Rail` and "
      "the flash temperature at `Speed`.";
  }

  void ContactParameters::declare_rolling(Entries &entries)
  {
    entries.add("Creepage x", creepages.x, "1")
      .or_empty()
      .read_by(read_creepages)
      .help =
      "Longitudinal creepage: sliding speed of the wheel over the rail along "
      "x, divided by the magnitude of the rolling speed.";
    entries.add("Creepage y", creepages.y, "1")
      .or_empty()
      .read_by(read_creepages)
      .help = "Lateral creepage, 3D only.";
    entries.add("Spin", creepages.spin, "1/m")
      .or_empty()
      .read_by(read_creepages)
      .help =
      "Spin creepage: angular velocity of the wheel over the rail about z, "
      "divided by the magnitude of the rolling speed. 3D only.";
    entries.add("Creepage size", creepage_size, "1").help =
      "Length of the vector of longitudinal and lateral creepage, given with "
      "`Creepage direction` in place of `Creepage x` and `Creepage y`. 3D "
      "only.";
    entries.add("Creepage direction", creepage_direction, "rad").help =
      "Direction of `Creepage size`: the angle from x towards y.";
    entries.add("Speed", speed, "m/s").help =
      "Rolling speed V: material flows through the contact along x in the "
      "direction of its sign. Empty for 1. With a constant friction "
      "coefficient a steady state depends on the sign only; with another "
      "Friction law the speed must be given.";
    entries.add("Longitudinal force", forces.x, "N").read_by(read_forces).help =
      "Force of friction on the wheel along x, less than mu N. Give it in "
      "place of `Creepage x`, which is found for it.";
    entries.add("Lateral force", forces.y, "N").read_by(read_forces).help =
      "Force of friction on the wheel along y, 3D only. Give it in place of "
      "`Creepage y`, which is found for it.";
    entries.add("Spin moment", forces.moment, "N m").read_by(read_forces).help =
      "Moment of friction on the wheel about the normal through the origin of "
      "the contact, 3D only. Give it in place of `Spin`, which is found for "
      "it.";
  }

  Creepages ContactParameters::asked_creepages() const
  {
    Creepages asked = creepages;
    if (!creepage_size)
      return asked;
    // whole quarters of a turn leave nothing of rounding
    const auto tidy = [](const double x) {
      return std::abs(x) < 1e-12 ? 0. : x;
    };
    asked.x = *creepage_size * tidy(std::cos(creepage_direction));
    asked.y = *creepage_size * tidy(std::sin(creepage_direction));
    return asked;
  }

  std::shared_ptr<const FrictionLaw> ContactParameters::falling_friction() const
  {
    return friction_coefficient > 0.
             ? make_friction_law(friction_law,
                                 kinetic_friction / friction_coefficient,
                                 friction_decay_speed)
             : nullptr;
  }

  void ContactParameters::check_friction_law() const
  {
    const auto law = falling_friction();
    if (!law && friction_memory_length > 0.)
      throw InputError(
        "Contact/Friction memory length = " + text_of(friction_memory_length) +
        " and Contact/Friction law = " + friction_law +
        ": only a law that falls has a memory; set it to 0 m, or "
        "take exponential or rational.");
    if (!law)
      return;
    if (!(kinetic_friction > 0.))
      throw InputError(
        "Contact/Kinetic friction coefficient = " + text_of(kinetic_friction) +
        ": Contact/Friction law = " + friction_law +
        " needs mu_k above 0. Friction falls with the speed if mu_k is below "
        "mu_s, Contact/Friction coefficient = " +
        text_of(friction_coefficient) +
        ", and rises if it is above, as with a friction modifier.");
    if (!(friction_decay_speed > 0.))
      throw InputError(
        "Contact/Friction decay speed = " + text_of(friction_decay_speed) +
        ": Contact/Friction law = " + friction_law +
        " needs the speed in m/s over which mu falls, above 0.");
  }

  void ContactParameters::check_load(const bool needs_load) const
  {
    std::vector<std::string> given;
    for (const auto &[entry, value] :
         {std::pair("Contact/Normal load", normal_load),
          std::pair("Contact/Vertical load", vertical_load),
          std::pair("Contact/Approach", approach)})
      if (value)
        given.push_back(std::string(entry) + " = " + text_of(*value));
    if (given.size() > 1)
      throw InputError(given[0] + " and " + given[1] +
                       ": give one of them and leave the other empty.");
    if (given.empty() && needs_load)
      throw InputError("Contact/Normal load and Contact/Approach are both "
                       "empty: give the load in N or the approach in m.");
    for (const auto &[entry, load] :
         {std::pair("Contact/Normal load", normal_load),
          std::pair("Contact/Vertical load", vertical_load)})
      if (load && *load < 0.)
        throw InputError(std::string(entry) + " = " + text_of(*load) +
                         ": contact cannot pull, give a load of at least 0 "
                         "N.");
  }

  void ContactParameters::check_forces(const unsigned int dimension) const
  {
    if (!forces.any())
      return;
    const double mu = friction_coefficient;
    for (const auto &[entry, force, creepage_entry, creepage] :
         {std::tuple("Longitudinal force", forces.x, "Creepage x", creepages.x),
          std::tuple("Lateral force", forces.y, "Creepage y", creepages.y),
          std::tuple("Spin moment", forces.moment, "Spin", creepages.spin)})
      {
        if (!force)
          continue;
        const std::string given =
          "Contact/" + std::string(entry) + " = " + text_of(*force);
        if (dimension == 2 && force != forces.x)
          throw InputError(given + ": lateral force and spin moment exist in "
                                   "3D only; leave it empty or take "
                                   "Dimension = 3.");
        if (creepage != 0.)
          throw InputError(given + " and Contact/" + creepage_entry + " = " +
                           text_of(creepage) +
                           ": the creepage is found for the force; leave one "
                           "of them out.");
        if (mu == 0.)
          throw InputError(given + " and Contact/Friction coefficient = 0: "
                                   "without friction there is no such force; "
                                   "leave it empty.");
      }
    const double asked =
      std::hypot(forces.x.value_or(0.), forces.y.value_or(0.));
    if (normal_load && asked >= mu * *normal_load)
      throw InputError(
        (forces.x ? "Contact/Longitudinal force = " + text_of(*forces.x) : "") +
        (forces.x && forces.y ? ", " : "") +
        (forces.y ? "Contact/Lateral force = " + text_of(*forces.y) : "") +
        ": under Contact/Normal load = " + text_of(*normal_load) +
        " N and mu = " + text_of(mu) + " friction carries less than mu N = " +
        text_of(mu * *normal_load) + " N.");
  }

  namespace
  {
    void check_creepage_size(const ContactParameters &contact,
                             const unsigned int       dimension)
    {
      if (!contact.creepage_size)
        return;
      const std::string given =
        "Contact/Creepage size = " + text_of(*contact.creepage_size);
      if (dimension == 2)
        throw InputError(given + ": in 2D there is one direction; give "
                                 "Contact/Creepage x and leave it empty.");
      const Creepages &creepages = contact.creepages;
      if ((creepages.x != 0. || creepages.y != 0.) &&
          !(creepages == contact.asked_creepages()))
        throw InputError(given + " and Contact/Creepage " +
                         (creepages.x != 0. ? "x = " + text_of(creepages.x)
                                            : "y = " + text_of(creepages.y)) +
                         ": give the size with its direction or the "
                         "components.");
      if (contact.forces.x || contact.forces.y)
        throw InputError(given + ": the creepages are found for a force, so "
                                 "that their size cannot be given; leave one "
                                 "of them out.");
    }
  } // namespace

  void ContactParameters::check(const unsigned int dimension,
                                const bool         needs_load) const
  {
    const Roughness understood(roughness);
    check_dimension_of_file("Contact/Roughness", roughness, dimension);
    const HotFriction hot(friction_over_temperature);
    check_load(needs_load);
    check_friction_law();
    if (rolling_speed() == 0.)
      throw InputError("Contact/Speed = 0: rolling needs a direction, give a "
                       "positive or negative speed.");
    check_creepage_size(*this, dimension);
    if (dimension == 2 && (creepages.y != 0. || creepages.spin != 0.))
      throw InputError(
        "Contact/" + std::string(creepages.spin != 0. ? "Spin" : "Creepage y") +
        " = " + text_of(creepages.spin != 0. ? creepages.spin : creepages.y) +
        ": lateral creepage and spin exist in 3D only; set it to 0 "
        "or take Dimension = 3.");
    check_forces(dimension);
  }
} // namespace RollingContact
