#ifndef rolling_contact_references_line_contact_approach_h
#define rolling_contact_references_line_contact_approach_h

#include <rolling_contact/references/hertz_line.h>

#include <functional>

namespace RollingContact::References
{
  /**
   * Approximate compression (m) of a disc of this radius (m), held at its
   * centre, between there and the middle of the patch under the Hertz pressure,
   * P = pi a p0/2 in plane strain (Johnson 1985, 5.57):
   *   (1-nu^2) P/(pi E) [2 ln(4 R/a) - 1].
   * It lies 1.6 % below that of the clamped annulus of the paper. E in Pa;
   * zero without a patch.
   */
  double compression_of_disc(const double     radius,
                             const double     young_modulus,
                             const double     poisson_ratio,
                             const HertzLine &contact);

  /**
   * Approximate compression (m) of a wide layer of depth D (m), held at its
   * bottom, under the Hertz pressure, P = pi a p0/2: the strain below the patch
   * of a half-plane (stresses Johnson 1985, 4.46) integrated down to D,
   *   2 (1-nu^2) P/(pi E) [asinh(D/a) - nu/(1-nu) (D/a) (sqrt(1+D^2/a^2) -
   * D/a)], for D >> a  (1-nu^2) P/(pi E) [2 ln(2 D/a) - nu/(1-nu)]. It lies 1
   * to 8 % below that of an infinite bonded layer with D = 5 a to 100 a. E in
   * Pa; zero without a patch.
   */
  double compression_of_layer(const double     depth,
                              const double     young_modulus,
                              const double     poisson_ratio,
                              const HertzLine &contact);

  /**
   * Smallest half-width (m) at which an approach (m) is reached, given the
   * approach as a function of the half-width that grows at least linearly from
   * zero on; zero if the approach is not positive. Throws an InputError if the
   * largest half-width does not reach it.
   */
  double half_width_of_approach(
    const std::function<double(double)> &approach_of_half_width,
    const double                         largest_half_width,
    const double                         approach);
} // namespace RollingContact::References

#endif
