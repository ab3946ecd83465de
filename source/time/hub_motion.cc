#include <rolling_contact/time/hub_motion.h>

namespace RollingContact
{
  double hub_acceleration_within(const DrivingFunctions &driving,
                                 const double            time,
                                 const double            h)
  {
    const auto &approach = driving.approach;
    if (!approach || approach->is_constant())
      return 0.;
    const double rounding = 1e-6 * h;
    const auto   at_start = [&]() {
      return 4 *
             (approach->value(h) - 2 * approach->value(h / 2) +
              approach->value(0.)) /
             (h * h);
    };
    if (time < rounding)
      return at_start();
    const double before =
      time < h + rounding ? at_start() : driving.hub_acceleration(time - h, h);
    return (3 * driving.hub_acceleration(time, h) - before) / 2;
  }
} // namespace RollingContact
