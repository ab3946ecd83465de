#ifndef rolling_contact_references_line_contact_stress_h
#define rolling_contact_references_line_contact_stress_h

namespace RollingContact::References
{
  /**
   * Stresses in a plane: x along the surface, z out of the body. Units: Pa.
   */
  struct PlaneStresses
  {
    double xx = 0., zz = 0., xz = 0.;
  };

  /**
   * The stresses below a half-plane with the pressure p0 sqrt(1 - x^2/a^2), at
   * x from its middle and a depth; @p peak is p0 (McEwen 1949; Johnson 1985,
   * 4.49). Units: m, Pa.
   */
  PlaneStresses stresses_of_pressure(const double x,
                                     const double depth,
                                     const double half_width,
                                     const double peak);

  /**
   * The stresses below the traction q0 sqrt(1 - x^2/a^2) along x; @p peak is q0
   * (Smith and Liu 1953; Johnson 1985, 7.8). Units: m, Pa.
   */
  PlaneStresses stresses_of_traction(const double x,
                                     const double depth,
                                     const double half_width,
                                     const double peak);
} // namespace RollingContact::References

#endif
