#ifndef rolling_contact_surfaces_conicity_h
#define rolling_contact_surfaces_conicity_h

#include <filesystem>
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

    /** Its integral from one shift to a larger one, exactly. Units: m^2. */
    double integral(const double from, const double to) const;

    /**
     * Whether it is known from -amplitude to amplitude.
     */
    bool covers(const double amplitude) const;
  };

  /**
   * The conicity of the cone pair with the same first harmonic of the radius
   * difference dr over a sinusoid of this amplitude A about the middle y0 of
   * the motion, see equivalent_conicity():
   *
   *   1/(2 pi A) integral_0^2pi dr(y0 + A sin phi) sin phi dphi.
   *
   * NaN if the table does not reach so far. Units: m, 1.
   */
  double harmonic_conicity(const RadiusDifference &dr, const double amplitude);

  /**
   * The equivalent conicity after EN 15302: that of the cone pair on which the
   * free wheelset, y'' + dr(y) / (e r0) = 0, has the same wave length L for
   * this amplitude, (2 pi / L)^2 e r0 / 2, which depends on neither e nor r0.
   * The motion is from y0 - A to y0 + A, with the integral of dr over it 0: y0
   * = 0 where both sides are alike, else another, as with two diameters of the
   * wheels. NaN if dr does not drive the wheelset back there, or the table does
   * not reach so far. Units: m, 1.
   */
  double equivalent_conicity(const RadiusDifference &dr,
                             const double            amplitude);

  /**
   * The radius difference of a file of two columns, see read_columns(): the
   * shift of the wheelset to the right, which ascends, and the right rolling
   * radius less the left one, both in @p unit (m). Throws InputError, naming
   * the file and what to do, if it is none.
   */
  RadiusDifference read_radius_difference(const std::filesystem::path &file,
                                          const double                 unit);
} // namespace RollingContact::Profiles

#endif
