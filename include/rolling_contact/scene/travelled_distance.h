#ifndef rolling_contact_scene_travelled_distance_h
#define rolling_contact_scene_travelled_distance_h

#include <rolling_contact/scene/time_function.h>

#include <vector>

namespace RollingContact
{
  /**
   * Integral of the rolling speed from t = 0, with its sign: how far the
   * material has moved along x. Exact for a constant speed, else by Gauss's
   * rule with 7 points in each of panels of equal length from 0, so that it is
   * the same number however it is asked for. Units: s, m/s, m.
   */
  class TravelledDistance
  {
  public:
    TravelledDistance(const TimeFunction &speed, const double panel);

    /**
     * At a time of at least 0. Throws InputError where the speed is not finite.
     */
    double value(const double time) const;

  private:
    double between(const double begin, const double end) const;

    TimeFunction                speed;
    double                      panel;
    mutable std::vector<double> at_panels{0.}; ///< as far as they were needed
  };
} // namespace RollingContact

#endif
