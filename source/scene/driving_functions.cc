#include <rolling_contact/scene/time_parameters.h>

namespace RollingContact
{
  bool DrivingFunctions::jump_between(const double begin,
                                      const double end) const
  {
    for (const auto *load : {&normal_load,
                             &approach,
                             &longitudinal_force,
                             &lateral_force,
                             &spin_moment})
      if (*load && (*load)->jumps_between(begin, end))
        return true;
    for (const auto *motion : {&creepage_x, &creepage_y, &spin, &speed})
      if (motion->jumps_between(begin, end))
        return true;
    return false;
  }

  AskedForces DrivingFunctions::forces(const double time) const
  {
    const auto at = [&](const std::optional<TimeFunction> &history) {
      return history ? history->value(time) : std::optional<double>();
    };
    return {at(longitudinal_force), at(lateral_force), at(spin_moment)};
  }

  double DrivingFunctions::hub_acceleration(const double time,
                                            const double h) const
  {
    if (!approach || approach->is_constant() || time <= 0.)
      return 0.;
    return (approach->value(time + h) - 2 * approach->value(time) +
            approach->value(time - h)) /
           (h * h);
  }
} // namespace RollingContact
