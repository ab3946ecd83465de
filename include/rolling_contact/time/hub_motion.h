#ifndef rolling_contact_time_hub_motion_h
#define rolling_contact_time_hub_motion_h

#include <rolling_contact/scene/time_parameters.h>

namespace RollingContact
{
  /**
   * Acceleration of the wheel's hub towards the rail in the middle of a step
   * from @p time to @p time + @p h, extrapolated from the approach until the
   * end of the step and two steps before it; of the first step from the slope
   * of the approach at its start, with which the bodies move already. Of second
   * order; times h it sums up to the change of the hub's velocity, also where
   * that jumps. 0 under a given load. Units: s, m/s^2.
   */
  double hub_acceleration_within(const DrivingFunctions &driving,
                                 const double            time,
                                 const double            h);
} // namespace RollingContact

#endif
