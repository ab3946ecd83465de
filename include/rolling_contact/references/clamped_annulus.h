#ifndef rolling_contact_references_clamped_annulus_h
#define rolling_contact_references_clamped_annulus_h

#include <vector>

namespace RollingContact::References
{
  /**
   * Annulus in plane strain: radii in m, E in Pa (infinite: rigid).
   */
  struct Annulus
  {
    double rim_radius;
    double hub_radius;
    double young_modulus;
    double poisson_ratio;
  };

  /**
   * Largest hub over rim radius that the series covers.
   */
  inline constexpr double largest_hub_ratio = 0.999;

  /**
   * Exact displacement of an annulus clamped at the hub under a Hertz pressure
   * p0 sqrt(1 - theta^2/alpha^2) on the rim r = R, alpha = a/R. A radial
   * traction -cos(n theta) moves the rim by -c_n R/(2 G) cos(n theta), with c_n
   * from Michell's solution (Muskhelishvili's potentials z^(n+1), z^(1-n) and
   * z^(n-1), z^(-n-1)). The slowly converging part, the full disc's
   *   c_n = [(3 - 4 nu)/(n+1) + 1/(n-1)]/2,  n >= 2,
   * is summed in closed form and integrated over the pressure; what the hub
   * adds to it decays as (hub/rim)^(2n) and is summed term by term.
   */
  class ClampedAnnulus
  {
  public:
    explicit ClampedAnnulus(const Annulus &annulus);

    /**
     * Radial displacement (positive outwards) of the rim at an angle (rad) from
     * the middle of the patch, for a half-width a (m), per load per length
     * P = pi a p0/2: m per N/m.
     */
    double radial_displacement(const double half_width,
                               const double angle = 0) const;

  private:
    /**
     * Response to the Hertz pressure with p0 = 1, inwards, over R/(2 G).
     */
    double disc_response(const double half_angle, const double angle) const;

    double hub_response(const double half_angle, const double angle) const;

    Annulus annulus;

    /**
     * Kolosov's constant 3 - 4 nu.
     */
    double kappa;

    /**
     * Coefficients c_0, c_1, then c_n less that of the full disc.
     */
    std::vector<double> hub_coefficients;
  };
} // namespace RollingContact::References

#endif
