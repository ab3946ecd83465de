#ifndef rolling_contact_damage_shakedown_h
#define rolling_contact_damage_shakedown_h

#include <vector>

namespace RollingContact::Damage
{
  /**
   * A largest shear stress below a contact over the peak pressure p0, and its
   * depth over the half-width a.
   */
  struct ShearPeak
  {
    double shear = 0.;
    double depth = 0.;
  };

  /**
   * The largest shear stress after Tresca, half the largest difference of the
   * three principal stresses, below a Hertz line contact that slides with
   * utilised friction mu_u, q = mu_u p, in plane strain: searched over x and
   * depth in the field of McEwen and of Smith and Liu
   * (references/line_contact_stress.h). The stress along the line counts at the
   * surface from mu_u = 0.248 on, at nu = 0.3. Checked: 0.3003 p0 at 0.786 a
   * without friction. Throws InputError unless mu_u >= 0 and -1 < nu <= 1/2.
   */
  ShearPeak line_shear(const double utilised_friction,
                       const double poisson_ratio = 0.3);

  /**
   * The largest |tau_xz| over all depths, for the contact of line_shear(): a
   * residual stress in steady rolling has parts along the surface alone, so
   * that this part of the stress is no shakedown's to take. Checked: p0/4 at
   * a/2 without friction, mu_u p0 at the surface from mu_u = 0.367 on.
   */
  ShearPeak line_orthogonal_shear(const double utilised_friction);

  /**
   * The largest shear stress after Tresca on the axis of a Hertz contact on a
   * circle of the radius a, without friction (Johnson 1985, 3.45): 0.310 p0 at
   * 0.48 a for nu = 0.3. Throws InputError unless -1 < nu <= 1/2.
   */
  ShearPeak circle_shear(const double poisson_ratio = 0.3);

  /**
   * Limits of the load factor p0/k at a utilised friction mu_u, for a contact
   * that slides all over, of an elastic, perfectly plastic body with the yield
   * stress k in shear: up to `elastic` nothing yields, up to `shakedown` what
   * yields at first is made elastic by residual stresses, and above it strain
   * goes on with every passage. Dimensionless.
   *
   * line_elastic    p0 over line_shear().
   * line_shakedown  p0 over line_orthogonal_shear(): Melan's theorem with
   *                 residual stresses sigma_x and sigma_y that depend on depth.
   * point_elastic   p0 over circle_shear(), and not above 1/mu_u: an upper
   *                 bound, exact without friction alone.
   * point_shakedown 4.7, and not above 1/mu_u: an upper bound; 4.7 after
   * Ponter, Hearle and Johnson 1985, recalled, unverified. surface 1/mu_u,
   * where the traction at the surface yields; infinite without friction.
   */
  struct ShakedownLimits
  {
    double utilised_friction = 0.;
    double line_elastic = 0., line_shakedown = 0.;
    double point_elastic = 0., point_shakedown = 0.;
    double surface = 0.;
  };

  /**
   * The limits at a utilised friction mu_u and Poisson's ratio nu. Throws
   * InputError unless mu_u >= 0 and -1 < nu <= 1/2.
   */
  ShakedownLimits shakedown_limits(const double utilised_friction,
                                   const double poisson_ratio = 0.3);

  /**
   * The shakedown map as a table: limits at equal steps of the utilised
   * friction from 0 to the most of it. Throws InputError unless that is
   * positive.
   */
  std::vector<ShakedownLimits>
  shakedown_map(const double       most_utilised_friction = 0.6,
                const unsigned int n_steps                = 60,
                const double       poisson_ratio          = 0.3);
} // namespace RollingContact::Damage

#endif
