#ifndef rolling_contact_references_hertz_line_h
#define rolling_contact_references_hertz_line_h

namespace RollingContact::References
{
  /**
   * Hertz contact of parallel cylinders: half-width a (m) and maximal pressure
   * p0 (Pa).
   */
  struct HertzLine
  {
    /**
     * Pressure p0 sqrt(1 - x^2/a^2) (Pa), x (m) from the middle of the patch;
     * zero outside.
     */
    double pressure(const double x) const;

    /**
     * Load per length pi a p0/2 (N/m).
     */
    double load_per_length() const;

    double half_width;
    double max_pressure;
  };

  /**
   * Hertz contact under a load per length P (N/m) with the relative radius R
   * (m) and the contact modulus E* (Pa): a = sqrt(4 P R/(pi E*)), p0 = 2 P/(pi
   * a) (Johnson 1985, 4.43 and 4.45).
   */
  HertzLine hertz_line(const double load_per_length,
                       const double relative_radius,
                       const double contact_modulus);

  /**
   * Hertz contact of a given half-width a (m), relative radius R (m) and
   * contact modulus E* (Pa): p0 = E* a/(2 R).
   */
  HertzLine hertz_line_of_half_width(const double half_width,
                                     const double relative_radius,
                                     const double contact_modulus);
} // namespace RollingContact::References

#endif
