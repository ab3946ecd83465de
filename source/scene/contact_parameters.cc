#include <rolling_contact/base/choices.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/contact/roughness.h>
#include <rolling_contact/scene/contact_parameters.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  ContactParameters::ContactParameters()
    : ParameterAcceptor("/Contact")
  {
    declare_load();
    declare_friction();
    declare_rolling();
    declare_operators();
  }



  void
  ContactParameters::declare_load()
  {
    add_parameter(
      "Normal load",
      normal_load_entry,
      "Force that presses the wheel on the rail; the approach follows. "
      "Give this or `Approach`. Units: N.",
      prm,
      Patterns::Anything());
    add_parameter(
      "Approach",
      approach_entry,
      "Displacement of the wheel's hub towards the rail from first touch; "
      "the load follows. Units: m.",
      prm,
      Patterns::Anything());
  }



  void
  ContactParameters::declare_friction()
  {
    add_parameter("Friction coefficient",
                  friction_coefficient,
                  "Coulomb's mu, the static mu_s of a law that falls; 0 leaves "
                  "all of friction out. Units: 1.",
                  prm,
                  Patterns::Double(0.));
    add_parameter("Friction law",
                  friction_law,
                  "How mu falls with the sliding speed v = |s| V from mu_s to "
                  "mu_k. " +
                    choice_help(friction_law_kinds()),
                  prm,
                  Patterns::Selection(choice_names(friction_law_kinds())));
    add_parameter("Kinetic friction coefficient",
                  kinetic_friction,
                  "mu_k of a law that falls, mu at high sliding speed. Polach: "
                  "0.4 mu_s, dry. Units: 1.",
                  prm,
                  Patterns::Double(0.));
    add_parameter("Friction decay speed",
                  friction_decay_speed,
                  "v_c of a law that falls. Polach: 1/0.6 m/s, dry. "
                  "Units: m/s.",
                  prm,
                  Patterns::Double(0.));
  }



  void
  ContactParameters::declare_rolling()
  {
    const Patterns::Double any;
    add_parameter(
      "Creepage x",
      creepages.x,
      "Longitudinal creepage, sliding speed of the wheel over the rail "
      "in x over the magnitude of the rolling speed. Units: 1.",
      prm,
      any);
    add_parameter("Creepage y",
                  creepages.y,
                  "Lateral creepage, 3D only. Units: 1.",
                  prm,
                  any);
    add_parameter(
      "Spin",
      creepages.spin,
      "Spin creepage, angular velocity about z of the wheel over the rail "
      "over the magnitude of the rolling speed, 3D only. Units: 1/m.",
      prm,
      any);
    add_parameter(
      "Speed",
      speed_entry,
      "Rolling speed V: material flows through the contact in the direction "
      "of its sign along x; empty for 1. With a constant friction coefficient "
      "a steady state depends on the sign only, with one that falls it must "
      "be given. Units: m/s.",
      prm,
      Patterns::Anything());
    parse_parameters_call_back.connect([&]() { read_speed(); });
  }



  void
  ContactParameters::declare_operators()
  {
    add_parameter("Slip operator",
                  slip_operator,
                  "B1. " + choice_help(slip_operator_choices()),
                  prm,
                  Patterns::Selection(choice_names(slip_operator_choices())));
    add_parameter("Contact matrices",
                  contact_matrices,
                  "H_n and H_t. " + choice_help(contact_matrices_choices()),
                  prm,
                  Patterns::Selection(
                    choice_names(contact_matrices_choices())));
    add_parameter(
      "Roughness",
      roughness,
      "Added to the gap of the smooth profiles: an expression in x and y "
      "(m) such as 2e-6*cos(2*pi*x/1e-3), with pi and the functions of the "
      "histories in section Time; empty for none. It does not travel with "
      "the material. Units: m.",
      prm,
      Patterns::Anything());
  }



  namespace
  {
    std::optional<double>
    number_or_empty(const std::string &entry,
                    const std::string &text,
                    const std::string &unit)
    {
      if (text.empty())
        return {};
      try
        {
          std::size_t  end   = 0;
          const double value = std::stod(text, &end);
          if (end == text.size() && std::isfinite(value))
            return value;
        }
      catch (const std::logic_error &)
        {}
      throw InputError("Contact/" + entry + " = " + text +
                       ": give a number in " + unit + ", or leave it empty.");
    }
  } // namespace



  std::optional<double>
  ContactParameters::normal_load() const
  {
    return number_or_empty("Normal load", normal_load_entry, "N");
  }



  std::optional<double>
  ContactParameters::approach() const
  {
    return number_or_empty("Approach", approach_entry, "m");
  }



  void
  ContactParameters::read_speed()
  {
    const auto given = number_or_empty("Speed", speed_entry, "m/s");
    speed            = given.value_or(1.);
    speed_is_given   = given.has_value();
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
    if (!law)
      return;
    const auto text = [](const double value) {
      return Patterns::Tools::to_string(value);
    };
    if (!(kinetic_friction > 0.) || kinetic_friction > friction_coefficient)
      throw InputError(
        "Contact/Kinetic friction coefficient = " + text(kinetic_friction) +
        ": Contact/Friction law = " + friction_law +
        " needs mu_k above 0 and at most mu_s, "
        "Contact/Friction coefficient = " +
        text(friction_coefficient) + ".");
    if (!(friction_decay_speed > 0.))
      throw InputError(
        "Contact/Friction decay speed = " + text(friction_decay_speed) +
        ": Contact/Friction law = " + friction_law +
        " needs the speed in m/s over which mu falls, above 0.");
  }



  void
  ContactParameters::check(const unsigned int dimension) const
  {
    const Roughness understood(roughness);
    const auto      load = normal_load();
    if (load && approach())
      throw InputError("Contact/Normal load = " + normal_load_entry +
                       " and Contact/Approach = " + approach_entry +
                       ": give one of them and leave the other empty.");
    if (!load && !approach())
      throw InputError(
        "Contact/Normal load and Contact/Approach are both empty: "
        "give the load in N or the approach in m.");
    if (load && *load < 0.)
      throw InputError("Contact/Normal load = " + normal_load_entry +
                       ": contact cannot pull, give a load of at least 0 N.");
    check_friction_law();
    if (speed == 0.)
      throw InputError("Contact/Speed = 0: rolling needs a direction, give a "
                       "positive or negative speed.");
    if (dimension == 2 && (creepages.y != 0. || creepages.spin != 0.))
      throw InputError(
        "Contact/" + std::string(creepages.spin != 0. ? "Spin" : "Creepage y") +
        " = " +
        Patterns::Tools::to_string(creepages.spin != 0. ? creepages.spin
                                                        : creepages.y) +
        ": lateral creepage and spin exist in 3D only; set it to 0 "
        "or take Dimension = 3.");
  }



  SlipOperatorKind
  ContactParameters::slip_operator_kind() const
  {
    return choice(slip_operator_choices(),
                  slip_operator,
                  "Contact/Slip operator")
      .kind;
  }



  ContactMatrices
  ContactParameters::contact_matrices_kind() const
  {
    return choice(contact_matrices_choices(),
                  contact_matrices,
                  "Contact/Contact matrices")
      .kind;
  }
} // namespace RollingContact
