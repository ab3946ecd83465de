#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/roughness.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/contact_parameters.h>

#include <cmath>
#include <tuple>

namespace RollingContact
{
  using namespace dealii;

  void
  ContactParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Contact");
    declare_load(prm);
    declare_friction(prm);
    declare_rolling(prm);
    declare_forces(prm);
    declare_operators(prm);
    prm.leave_subsection();
  }



  void
  ContactParameters::declare_load(ParameterHandler &prm)
  {
    declare_number(prm,
                   "Contact/Normal load",
                   normal_load,
                   "N",
                   "Force that presses the wheel on the rail; the approach "
                   "follows. Give this, `Vertical load` or `Approach`. Units: "
                   "N.");
    declare_number(prm,
                   "Contact/Vertical load",
                   vertical_load,
                   "N",
                   "Vertical force of the rail on the wheel, which the normal "
                   "load and friction share where profiles touch at an angle. "
                   "Units: N.");
    declare_number(prm,
                   "Contact/Approach",
                   approach,
                   "m",
                   "Displacement of the wheel's hub towards the rail from "
                   "first touch; the load follows. Units: m.");
  }



  void
  ContactParameters::declare_friction(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Friction coefficient",
      friction_coefficient,
      "Coulomb's mu, the static mu_s of a law that falls; 0 leaves "
      "all of friction out. Units: 1.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Friction law",
      friction_law,
      "How mu changes with the sliding speed v = |s| V from mu_s to mu_k: it "
      "falls, or rises where mu_k is above mu_s. " +
        choice_help(friction_law_kinds()),
      Patterns::Selection(choice_names(friction_law_kinds())));
    prm.add_parameter(
      "Kinetic friction coefficient",
      kinetic_friction,
      "mu_k of a law that falls, mu at high sliding speed. Polach: 0.4 mu_s, "
      "dry. Above mu_s friction rises, as with a friction modifier. Units: 1.",
      Patterns::Double(0.));
    prm.add_parameter("Friction decay speed",
                      friction_decay_speed,
                      "v_c of a law that falls. Polach: 1/0.6 m/s, dry. "
                      "Units: m/s.",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Friction memory length",
      friction_memory,
      "Sliding distance of a point of the material over which mu comes to "
      "that of a law that falls, micrometres; 0: at once. Units: m.",
      Patterns::Double(0.));
    prm.add_parameter(
      "Friction response",
      friction_response,
      "How mu of a law that falls follows a state that changes in time or is "
      "disturbed. `patch mean`: mu of all nodes, by the mean speed of the "
      "patch with a delay; `node`: mu of each node, by its own speed at once, "
      "which is ill-posed where friction falls; `constant`: not at all; "
      "`automatic`: patch mean in Analysis = stability and with Time/Bodies = "
      "reduced, else node.",
      Patterns::Selection("automatic|patch mean|node|constant"));
    prm.add_parameter("Friction memory",
                      friction_delay,
                      "Delay of `patch mean`; a tenth of it is the longest "
                      "time step. Units: s.",
                      Patterns::Double(0.));
  }



  void
  ContactParameters::declare_rolling(ParameterHandler &prm)
  {
    const Patterns::Double any;
    prm.add_parameter(
      "Creepage x",
      creepages.x,
      "Longitudinal creepage, sliding speed of the wheel over the rail "
      "in x over the magnitude of the rolling speed. Units: 1.",
      any);
    prm.add_parameter("Creepage y",
                      creepages.y,
                      "Lateral creepage, 3D only. Units: 1.",
                      any);
    prm.add_parameter(
      "Spin",
      creepages.spin,
      "Spin creepage, angular velocity about z of the wheel over the rail "
      "over the magnitude of the rolling speed, 3D only. Units: 1/m.",
      any);
    declare_number(prm,
                   "Contact/Creepage size",
                   creepage_size,
                   "1",
                   "In place of `Creepage x` and `Creepage y`, 3D only: the "
                   "length of both together, in the `Creepage direction`. "
                   "Units: 1.");
    prm.add_parameter("Creepage direction",
                      creepage_direction,
                      "Of `Creepage size`: the angle from x towards y. Units: "
                      "rad.",
                      any);
    declare_number(
      prm,
      "Contact/Speed",
      speed,
      "m/s",
      "Rolling speed V: material flows through the contact in the direction "
      "of its sign along x; empty for 1. With a constant friction coefficient "
      "a steady state depends on the sign only, with one that falls it must "
      "be given. Units: m/s.");
  }



  void
  ContactParameters::declare_forces(ParameterHandler &prm)
  {
    declare_number(prm,
                   "Contact/Longitudinal force",
                   forces.x,
                   "N",
                   "Force of friction on the wheel along x in place of "
                   "`Creepage x`, which is found for it. Less than mu N. "
                   "Units: N.");
    declare_number(prm,
                   "Contact/Lateral force",
                   forces.y,
                   "N",
                   "Force of friction on the wheel along y, 3D only, in place "
                   "of `Creepage y`, which is found for it. Units: N.");
    declare_number(prm,
                   "Contact/Spin moment",
                   forces.moment,
                   "N m",
                   "Moment of friction on the wheel about the normal through "
                   "the origin of the contact, 3D only, in place of `Spin`, "
                   "which is found for it. Units: N m.");
  }



  void
  ContactParameters::declare_operators(ParameterHandler &prm)
  {
    declare_choice(prm,
                   "Slip operator",
                   slip_operator,
                   slip_operator_choices(),
                   "B1. " + choice_help(slip_operator_choices()));
    declare_choice(prm,
                   "Contact matrices",
                   contact_matrices,
                   contact_matrices_choices(),
                   "H_n and H_t. " + choice_help(contact_matrices_choices()));
    prm.add_parameter(
      "Roughness",
      roughness,
      "Added to the gap of the smooth profiles: an expression in x and y "
      "(m) such as 2e-6*cos(2*pi*x/1e-3), with pi and the functions of the "
      "histories in section Time; empty for none. It does not travel with "
      "the material. Units: m.",
      Patterns::Anything());
  }



  void
  ContactParameters::take_creepage_by_size()
  {
    if (!creepage_size)
      return;
    // whole quarters of a turn leave nothing of rounding
    const auto tidy = [](const double x) {
      return std::abs(x) < 1e-12 ? 0. : x;
    };
    creepages.x = *creepage_size * tidy(std::cos(creepage_direction));
    creepages.y = *creepage_size * tidy(std::sin(creepage_direction));
  }



  std::shared_ptr<const FrictionLaw>
  ContactParameters::falling_friction() const
  {
    return friction_coefficient > 0.
             ? make_friction_law(friction_law,
                                 kinetic_friction / friction_coefficient,
                                 friction_decay_speed)
             : nullptr;
  }



  void
  ContactParameters::check_friction_law() const
  {
    const auto law = falling_friction();
    if (!law && friction_memory > 0.)
      throw InputError(
        "Contact/Friction memory length = " + text_of(friction_memory) +
        " and Contact/Friction law = " + friction_law +
        ": only a law that falls has a memory; set it to 0 m, or "
        "take exponential or rational.");
    if (!law)
      return;
    if (!(kinetic_friction > 0.))
      throw InputError(
        "Contact/Kinetic friction coefficient = " + text_of(kinetic_friction) +
        ": Contact/Friction law = " + friction_law +
        " needs mu_k above 0; below mu_s, Contact/Friction coefficient = " +
        text_of(friction_coefficient) +
        ", friction falls with the speed, above it rises, as by a friction "
        "modifier.");
    if (!(friction_decay_speed > 0.))
      throw InputError(
        "Contact/Friction decay speed = " + text_of(friction_decay_speed) +
        ": Contact/Friction law = " + friction_law +
        " needs the speed in m/s over which mu falls, above 0.");
  }



  void
  ContactParameters::check_load() const
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
    if (given.empty())
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



  void
  ContactParameters::check_forces(const unsigned int dimension) const
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
    void
    check_creepage_size(const ContactParameters &contact,
                        const unsigned int       dimension)
    {
      if (!contact.creepage_size)
        return;
      const std::string given =
        "Contact/Creepage size = " + text_of(*contact.creepage_size);
      if (dimension == 2)
        throw InputError(given + ": in 2D there is one direction; give "
                                 "Contact/Creepage x and leave it empty.");
      const Creepages  &creepages = contact.creepages;
      ContactParameters derived   = contact;
      derived.take_creepage_by_size();
      if ((creepages.x != 0. || creepages.y != 0.) &&
          !(creepages == derived.creepages))
        throw InputError(given + " and Contact/Creepage " +
                         (creepages.x != 0. ? "x = " + text_of(creepages.x)
                                            : "y = " + text_of(creepages.y)) +
                         ": give the size with its direction or the "
                         "components.");
      if (contact.forces.x || contact.forces.y)
        throw InputError(given + ": a creepage that is found for a force is "
                                 "given by no size; leave one of them out.");
    }
  } // namespace



  void
  ContactParameters::check(const unsigned int dimension) const
  {
    const Roughness understood(roughness);
    check_load();
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
