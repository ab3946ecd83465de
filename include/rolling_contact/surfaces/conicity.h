#ifndef rolling_contact_surfaces_conicity_h
#define rolling_contact_surfaces_conicity_h

#include <vector>

namespace RollingContact::Profiles
{
  /**
   * The difference of the rolling radii, right minus left, over the lateral
   * shift of a wheelset, linear between shifts that ascend. Units: m.
   */
  struct RadiusDifference
  {
    std::vector<double> shift, difference;

    double at(const double shift_there) const;

    /**
     * Whether it is known from -amplitude to amplitude.
     */
    bool covers(const double amplitude) const;
  };

  /**
   * The conicity of the cone pair with the same first harmonic of the radius
   * difference dr over a sinusoid of this amplitude A:
   *
   *   1/(2 pi A) integral_0^2pi dr(A sin phi) sin phi dphi.
   *
   * Units: m, 1.
   */
  double harmonic_conicity(const RadiusDifference &dr, const double amplitude);

  /**
   * The equivalent conicity after EN 15302: that of the cone pair on which the
   * free wheelset, y'' + dr(y) / (e r0) = 0, has the same wave length L for
   * this amplitude, (2 pi / L)^2 e r0 / 2, which depends on neither e nor r0.
   * The motion is taken about the middle: from -amplitude to amplitude. NaN if
   * dr does not drive the wheelset back there. Units: m, 1.
   */
  double equivalent_conicity(const RadiusDifference &dr,
                             const double            amplitude);
} // namespace RollingContact::Profiles

#endif
