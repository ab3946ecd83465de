#ifndef rolling_contact_references_hertz_ellipse_h
#define rolling_contact_references_hertz_ellipse_h

namespace RollingContact::References
{
  /**
   * Hertz contact on an ellipse: semi-axes a along x and b along y (m), maximal
   * pressure p0 (Pa), approach of distant points (m).
   */
  struct HertzEllipse
  {
    /**
     * Pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2) (Pa), x and y (m) from the middle
     * of the patch; zero outside.
     */
    double pressure(const double x, const double y) const;

    /**
     * Load 2 pi a b p0/3 (N).
     */
    double load() const;

    double half_width_x;
    double half_width_y;
    double max_pressure;
    double approach;
  };

  /**
   * Contact under a load P (N) of bodies with the initial gap A x^2 + B y^2
   * (A, B in 1/m, A = (1/R1x + 1/R2x)/2) and the contact modulus E* (Pa). In
   * Carlson's integrals (Johnson 1985, section 4.2, symmetric form):
   *   A = P RD(0, b^2, a^2)/(2 pi E*),  B = P RD(0, a^2, b^2)/(2 pi E*),
   *   approach = 3 P RF(0, a^2, b^2)/(2 pi E*),  p0 = 3 P/(2 pi a b).
   */
  HertzEllipse hertz_ellipse(const double load,
                             const double curvature_x,
                             const double curvature_y,
                             const double contact_modulus);

  /**
   * Load (N) of hertz_ellipse() at an approach (m), zero if that is not
   * positive.
   */
  double load_of_hertz_ellipse(const double approach,
                               const double curvature_x,
                               const double curvature_y,
                               const double contact_modulus);
} // namespace RollingContact::References

#endif
