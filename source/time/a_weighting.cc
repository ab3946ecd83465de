#include <rolling_contact/time/a_weighting.h>

#include <cmath>

namespace RollingContact::Sound
{
  namespace
  {
    double response(const double f)
    {
      const double s = f * f, s1 = std::pow(20.598997, 2),
                   s2 = std::pow(107.65265, 2), s3 = std::pow(737.86223, 2),
                   s4 = std::pow(12194.217, 2);
      return s4 * s * s /
             ((s + s1) * std::sqrt((s + s2) * (s + s3)) * (s + s4));
    }
  } // namespace

  double a_weighting(const double frequency)
  {
    const double ratio = response(frequency) / response(1000.);
    return ratio * ratio;
  }
} // namespace RollingContact::Sound
