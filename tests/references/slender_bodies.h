#ifndef rolling_contact_tests_references_slender_bodies_h
#define rolling_contact_tests_references_slender_bodies_h

namespace RollingContact::References
{
  /**
   * A prismatic bar of rectangular section, bent in the plane of its depth.
   * Units: m, Pa, kg/m^3.
   */
  struct Bar
  {
    double length        = 1.;
    double width         = 0.1;
    double depth         = 0.1;
    double young_modulus = 210e9;
    double shear_modulus = 81e9;
    double density       = 7850.;

    double area() const
    {
      return width * depth;
    }

    /**
     * Second moment of area in bending, b d^3 / 12. Units: m^4.
     */
    double second_moment() const
    {
      return width * depth * depth * depth / 12;
    }
  };

  /**
   * Deflection of the end of a clamped bar for a unit force on it, L^3 / (3 E
   * I) + L / (5/6 G A) (Timoshenko). Units: m/N.
   */
  double cantilever_compliance(const Bar &bar);

  /**
   * Natural frequency number @p number = 1, 2, ... of a clamped slender bar in
   * bending, (beta L)^2 sqrt(E I / (rho A)) / (2 pi L^2) with cos(beta L)
   * cosh(beta L) = -1 (Euler and Bernoulli). Units: Hz.
   */
  double cantilever_frequency(const Bar &bar, const unsigned int number);

  /**
   * Torsional stiffness G J of a rectangular section, moment over twist per
   * length (Saint-Venant's series). Units: N m^2.
   */
  double torsional_stiffness(const Bar &bar);

  /**
   * Frequency of a free thin ring bent in its plane with n = 2, 3, ...
   * nodal diameters: omega^2 = E I / (rho A R^4) n^2 (n^2 - 1)^2 / (n^2 + 1)
   * (Hoppe 1871); the depth of the @p section is radial, R that of its middle.
   * Units: m, Hz.
   */
  double free_ring_frequency(const Bar         &section,
                             const double       radius,
                             const unsigned int n_diameters);

  /**
   * Deflection under a unit force of an infinite Euler-Bernoulli beam on
   * springs of @p stiffness per length: lambda / (2 k), lambda^4 = k / (4 E I)
   * (Winkler 1867, Zimmermann 1888). Units: N m^2, N/m^2, m/N.
   */
  double winkler_beam_compliance(const double bending_stiffness,
                                 const double stiffness);
} // namespace RollingContact::References

#endif
