#ifndef rolling_contact_time_radiation_efficiency_h
#define rolling_contact_time_radiation_efficiency_h

namespace RollingContact::Sound
{
  /**
   * Radiation efficiency of a railway wheel that vibrates along its axle with n
   * nodal diameters,
   *
   *   sigma = 1 / (1 + (f_c/f)^(2n+4)),
   *   f_c   = c (1.9 + 1.015 n - 0.0189 n^2) / (2 pi R),
   *
   * fitted to boundary elements by Thompson and Jones, J. Sound Vib. 253
   * (2002) 401. Units: m, m/s, Hz; 1.
   */
  double axial_efficiency_of_wheel(const unsigned int nodal_diameters,
                                   const double       radius,
                                   const double       speed_of_sound,
                                   const double       frequency);

  /**
   * Radiation efficiency of a wheel whose rim, of the given width w, vibrates
   * radially with n nodal diameters. Monopoles around a circle of the radius R,
   * of the strength cos(n theta), radiate
   *
   *   s = k^2 R w / 4 int_0^pi J_n(k R sin t)^2 sin t dt
   *     = k w / 2 sum_(i >= 0) J_(2n+2i+1)(2 k R),      k = 2 pi f / c,
   *
   * times rho c times the area 2 pi R w and the mean square of the velocity:
   * for n = 0 and low f the small source k^2 S / (4 pi). That is exact for a
   * narrow rim without a web; where it is not narrow s / (1 + s) goes over into
   * 1. What moves the other way below the rim is left out, so that low
   * frequencies are overestimated. Units: m, m/s, Hz; 1.
   */
  double radial_efficiency_of_wheel(const unsigned int nodal_diameters,
                                    const double       radius,
                                    const double       width,
                                    const double       speed_of_sound,
                                    const double       frequency);

  /**
   * Radiation efficiency of a long cylinder of radius a that moves to and fro
   * across its axis, alike all along,
   *
   *   sigma = 2 / (pi k a |H_1'(k a)|^2),     pi (k a)^3 / 2 for low f,
   *
   * H_1 = J_1 + i Y_1: exact for a plane field. It holds for a beam whose
   * waves are longer than those in air. Units: m, m/s, Hz; 1.
   */
  double efficiency_of_cylinder(const double radius,
                                const double speed_of_sound,
                                const double frequency);

  /**
   * The radius a for which efficiency_of_cylinder() is right at low frequencies
   * for a prismatic body of the section A, the extent @p width across its
   * motion e, and s = int (n . e)^2 along the outline:
   *
   *   a^3 = D^2 / (4 pi s),     D = A + pi width^2 / 4,
   *
   * as it radiates rho c k^3 D^2 v^2 / 8 per length as a dipole, D being its
   * own area and that of the air it carries along; this D is exact for all
   * ellipses from the plate to the circle. Units: m^2, m, m; m.
   */
  double equivalent_radius(const double section,
                           const double width,
                           const double normal_length);
} // namespace RollingContact::Sound

#endif
