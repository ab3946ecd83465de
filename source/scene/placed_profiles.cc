#include <deal.II/base/parameter_handler.h>

#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/profiles/nominal_profiles.h>
#include <rolling_contact/scene/profile_parameters.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  void
  ProfileParameters::declare_bodies(ParameterHandler &prm)
  {
    declare_choice(
      prm,
      "Body sections",
      true_sections,
      std::vector<NamedValue<bool>>{{"plain", false}, {"true", true}},
      "What is under the profiles of elastic bodies: `plain`, the disc and the "
      "block of sections Wheel and Rail; `true`, a wheel with flange, rim, web "
      "and hub, held at its bore (Wheel/Hub radius), and a rail with head, web "
      "and foot of a 60E1, Rail/Block length long, held at its sole.");
    prm.add_parameter("Web bow",
                      web_bow,
                      "By how much the middle of a true wheel's web is bowed "
                      "towards the field side. Units: m.",
                      Patterns::Double());
  }



  std::shared_ptr<const PlacedProfile>
  ProfileParameters::placed_wheel() const
  {
    const auto &pair = frame->wheel_on_rail();
    const auto  arc_length =
      [frame = frame](const double across) -> std::optional<double> {
      return frame->wheel_arc_length(frame->is_left() ? -across : across);
    };
    PlacedProfile placed{pair.wheel_profile(), arc_length};
    placed.turn    = frame->roll() - frame->origin().angle;
    placed.radius  = pair.wheel_radius();
    placed.bow     = web_bow;
    placed.is_left = is_left;
    return std::make_shared<const PlacedProfile>(placed);
  }



  std::shared_ptr<const PlacedProfile>
  ProfileParameters::placed_rail() const
  {
    // web and foot are those of a new rail with the same top and gauge face
    const double inclination = std::atan(slope_of_inclination());
    const auto   nominal     = Profiles::placed_rail(Profiles::rail_60e1(),
                                               slope_of_inclination(),
                                               gauge,
                                               gauge_height);
    const auto   crown       = nominal.at(nominal.length() / 2);
    const auto   arc_length =
      [frame = frame](const double across) -> std::optional<double> {
      const double s = frame->is_left() ? -across : across;
      if (!frame->covers(s))
        return {};
      return frame->rail_arc_length(s);
    };
    PlacedProfile placed{frame->wheel_on_rail()
                           .rail_profile()
                           .shifted(-crown.y, -crown.z)
                           .turned(inclination),
                         arc_length};
    placed.turn    = inclination + frame->origin().angle;
    placed.is_left = is_left;
    return std::make_shared<const PlacedProfile>(placed);
  }
} // namespace RollingContact
