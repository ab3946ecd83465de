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
     * p0 sqrt(1 - x^2/a^2) (Pa), x (m) from the middle of the patch; zero
     * outside.
     */
    double
    pressure(const double x) const;

    /**
     * pi a p0/2 (N/m).
     */
    double
    load_per_length() const;

    double half_width;
    double max_pressure;
  };

  /**
   * a = sqrt(4 P R/(pi E*)), p0 = 2 P/(pi a) for a load per length P (N/m), the
   * relative radius R (m) and the contact modulus E* (Pa) (Johnson 1985, 4.43
   * and 4.45).
   */
  HertzLine
  hertz_line(const double load_per_length,
             const double relative_radius,
             const double contact_modulus);

  /**
   * The same for a given half-width a (m): p0 = E* a/(2 R).
   */
  HertzLine
  hertz_line_of_half_width(const double half_width,
                           const double relative_radius,
                           const double contact_modulus);
} // namespace RollingContact::References

#endif
