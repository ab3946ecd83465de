#ifndef rolling_contact_references_falling_half_spaces_h
#define rolling_contact_references_falling_half_spaces_h

#include <vector>

namespace RollingContact::References
{
  /**
   * An elastic half-space as a wave along its surface, polarised across its
   * way, feels it.
   */
  struct ShearedHalfSpace
  {
    double shear_modulus; ///< G, Pa
    double density;       ///< kg/m^3
  };

  /**
   * How much more the traction falls with the sliding speed than the
   * half-spaces in contact radiate as waves:
   *
   *   fall sum_b 1 / (rho_b c_b),      c_b = sqrt(G_b / rho_b),
   *
   * @p fall = p |dmu/dv| in Pa s/m. Above 1 friction that falls at each point
   * at once is ill-posed: see falling_friction_growth(). A rigid body is left
   * out of @p bodies.
   */
  double falling_friction_gain(const double                         fall,
                               const std::vector<ShearedHalfSpace> &bodies);

  /**
   * The rate s at which a disturbance of the sliding of half-spaces grows that
   * is a wave of this length (m) across the direction of sliding, where
   * friction falls at each point at once (Rice, Lapusta and Ranjith 2001, pure
   * rate dependence):
   *
   *   1 = fall s sum_b 1 / (G_b sqrt(k^2 + s^2 / c_b^2)),     k = 2 pi /
   * length.
   *
   * With two equal bodies s = c k / sqrt(gain^2 - 1). It goes with k: there is
   * no limit for short waves. 0 where the gain is 1 or less. Units: 1/s.
   */
  double falling_friction_growth(const double                         fall,
                                 const std::vector<ShearedHalfSpace> &bodies,
                                 const double wavelength);
} // namespace RollingContact::References

#endif
