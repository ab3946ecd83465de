#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/profile_parameters.h>

#include <cmath>

namespace RollingContact
{
  using namespace dealii;

  std::shared_ptr<const PlacedProfile>
  ProfileParameters::placed_wheel(const Frame &frame) const
  {
    const auto &pair = frame->wheel_on_rail();
    const auto  arc_length =
      [frame](const double across) -> std::optional<double> {
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
  ProfileParameters::placed_rail(const Frame &frame) const
  {
    // web and foot are those of a new rail with the same top and gauge face,
    // of a file a 60E1
    const double inclination = std::atan(slope_of_inclination());
    const auto   nominal     = Profiles::placed_rail(nominal_rail(),
                                               slope_of_inclination(),
                                               gauge,
                                               gauge_height);
    const auto   crown       = nominal.at(nominal.length() / 2);
    const auto   arc_length =
      [frame](const double across) -> std::optional<double> {
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
