#include <rolling_contact/scene/time_parameters.h>

namespace RollingContact
{
  bool
  DrivingFunctions::jump_between(const double begin, const double end) const
  {
    for (const auto *load : {&normal_load, &approach})
      if (*load && (*load)->jumps_between(begin, end))
        return true;
    for (const auto *motion : {&creepage_x, &creepage_y, &spin, &speed})
      if (motion->jumps_between(begin, end))
        return true;
    return false;
  }



  double
  DrivingFunctions::hub_acceleration(const double time, const double h) const
  {
    if (!approach || approach->is_constant() || time <= 0.)
      return 0.;
    return (approach->value(time + h) - 2 * approach->value(time) +
            approach->value(time - h)) /
           (h * h);
  }
} // namespace RollingContact
