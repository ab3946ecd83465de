#ifndef rolling_contact_time_a_weighting_h
#define rolling_contact_time_a_weighting_h

namespace RollingContact::Sound
{
  /**
   * Frequency weighting A of IEC 61672-1 as a factor of power,
   *   (R(f) / R(1000))^2,   R(f) = f4^2 f^4 / ((f^2 + f1^2) (f^2 + f2^2)^(1/2)
   *                                (f^2 + f3^2)^(1/2) (f^2 + f4^2)),
   * f1, f2, f3, f4 = 20.598997, 107.65265, 737.86223, 12194.217 Hz. Units: Hz,
   * 1.
   */
  double a_weighting(const double frequency);
} // namespace RollingContact::Sound

#endif
