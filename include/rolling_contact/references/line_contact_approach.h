#ifndef rolling_contact_references_line_contact_approach_h
#define rolling_contact_references_line_contact_approach_h

#include <rolling_contact/references/hertz_line.h>

#include <array>
#include <functional>

namespace RollingContact::References
{
  /**
   * One body of a line contact, in plane strain. The extent (m) is the radius
   * of a disc, held at its centre, or the depth of a wide block, held at that
   * depth. E in Pa.
   */
  struct LineBody
  {
    enum class Shape
    {
      disc,
      block
    };

    Shape  shape;
    double extent;
    double young_modulus;
    double poisson_ratio;
    bool   rigid = false;
  };

  using LineBodies = std::array<LineBody, 2>;

  /**
   * Relative radius (m) of the two bodies; a block is flat.
   */
  double
  relative_radius(const LineBodies &bodies);

  /**
   * Contact modulus (Pa) of the two bodies.
   */
  double
  contact_modulus(const LineBodies &bodies);

  /**
   * Approximate compression (m) of one body between the middle of the patch and
   * the place where it is held, under the Hertz pressure, P = pi a p0/2:
   * disc (Johnson 1985, 5.57), (1-nu^2) P/(pi E) [2 ln(4 R/a) - 1];
   * block of depth D, the strain below the patch of a half-plane (stresses
   * Johnson 1985, 4.46) integrated down to D,
   * 2 (1-nu^2) P/(pi E) [asinh(D/a) - nu/(1-nu) (D/a) (sqrt(1+D^2/a^2) - D/a)],
   * for D >> a  (1-nu^2) P/(pi E) [2 ln(2 D/a) - nu/(1-nu)].
   * Both are a little small: the disc's 1.6 % below the clamped annulus of the
   * paper, the block's 1 to 8 % below an infinite layer bonded at D = 5 a to
   * 100 a.
   */
  double
  compression(const LineBody &body, const HertzLine &contact);

  /**
   * Approach (m) of the two bodies under a load per length (N/m).
   */
  double
  approach_of_line_contact(const LineBodies &bodies,
                           const double      load_per_length);

  /**
   * Inverse of approach_of_line_contact(): load per length (N/m) for an
   * approach (m), zero if that is not positive.
   */
  double
  load_of_line_contact(const LineBodies &bodies, const double approach);

  /**
   * Half-width (m) at which an approach (m) is reached, given the approach as a
   * function of the half-width that grows at least linearly; zero if the
   * approach is not positive. Throws an InputError if the largest half-width
   * does not reach it.
   */
  double
  half_width_of_approach(
    const std::function<double(double)> &approach_of_half_width,
    const double                         largest_half_width,
    const double                         approach);
} // namespace RollingContact::References

#endif
