#ifndef rolling_contact_references_layered_line_h
#define rolling_contact_references_layered_line_h

#include <rolling_contact/references/layered_pair.h>

#include <vector>

namespace RollingContact::References
{
  /**
   * Whether bodies slide on each other without friction or stick all over the
   * patch.
   */
  enum class LineFriction
  {
    none,
    sticks
  };

  /**
   * Line contact of parallel cylinders with layers on them. Pressure and
   * traction are
   *   p = sqrt(1-t^2) sum_j c_j U_2j(t),  q = sqrt(1-t^2) sum_j d_j U_2j+1(t)
   * with t = x/a and Chebyshev's polynomials of the second kind; q acts on body
   * 1 in +x. Units: m, Pa.
   */
  struct LayeredLine
  {
    double pressure(const double x) const;

    double traction(const double x) const;

    /**
     * Load per length pi a c_0/2 (N/m).
     */
    double load_per_length() const;

    /**
     * Largest |q|/p over the patch: with as much friction nothing slides. 0
     * without friction.
     */
    double least_friction() const;

    double half_width = 0.;

    /**
     * Approach beyond that of both cores under Hertz's pressure of the same
     * load and half-width.
     */
    double approach_of_layers = 0.;

    /**
     * Strain of body 1 along x over that of body 2, the same all over a patch
     * that sticks: freely rolling, body 1 runs so much further than its radius
     * has it. 0 without friction.
     */
    double creepage = 0.;

    std::vector<double> pressure_terms, traction_terms; ///< c and d
  };

  /**
   * The line contact of this half-width a (m) between two bodies with the
   * relative radius R (m). The slope of the surfaces, x/R under the patch, and
   * where bodies stick the constant difference of their strains are met at the
   * zeros of a Chebyshev polynomial. Integrals of Bessel functions over wave
   * numbers give what layers add to half-planes of their surface's material,
   * which are known in closed form. A patch that sticks is that of free rolling
   * with friction from least_friction() on (Bentall and Johnson 1968): the
   * traction is odd and zero at both edges, and pulls nothing. @p n_terms of
   * each series, 0: as many as the layers ask for. Throws InputError if a layer
   * is thinner than a hundredth of a.
   */
  LayeredLine layered_line_of_half_width(const double       half_width,
                                         const LayeredPair &bodies,
                                         const double       relative_radius,
                                         const LineFriction friction,
                                         const unsigned int n_terms = 0);

  /**
   * The line contact under this load per length (N/m), see
   * layered_line_of_half_width().
   */
  LayeredLine layered_line(const double       load_per_length,
                           const LayeredPair &bodies,
                           const double       relative_radius,
                           const LineFriction friction,
                           const unsigned int n_terms = 0);

  /**
   * Load per length (N/m) of a thin layer of thickness h on a rigid body that
   * a rigid cylinder of radius R presses over 2 a: with nu < 1/2 it is a
   * foundation, P = 2 E (1-nu) a^3/(3 (1+nu)(1-2 nu) R h), and with nu = 1/2 P
   * = 2 E a^5/(45 R h^3) as it keeps its volume (Johnson 1985, 5.8). Limits for
   * h << a, several percent off at h/a = 0.1.
   */
  double load_of_thin_layer(const double half_width,
                            const double thickness,
                            const double young_modulus,
                            const double poisson_ratio,
                            const double relative_radius);
} // namespace RollingContact::References

#endif
