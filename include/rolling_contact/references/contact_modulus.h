#ifndef rolling_contact_references_contact_modulus_h
#define rolling_contact_references_contact_modulus_h

namespace RollingContact::References
{
  /**
   * Contact modulus E* (Pa) of two bodies, 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2
   * (Johnson 1985, section 4.2). A rigid body has E = infinity: it contributes
   * nothing.
   */
  double contact_modulus(const double young_modulus_1,
                         const double poisson_ratio_1,
                         const double young_modulus_2,
                         const double poisson_ratio_2);

  /**
   * Dundurs' constant of two bodies in plane strain,
   *   beta = [(1-2nu1)/G1 - (1-2nu2)/G2] / (2 [(1-nu1)/G1 + (1-nu2)/G2])
   * (Johnson 1985, section 5.1). Positive if body 1 has the larger (1-2nu)/G:
   * under the same pressure its surface is drawn towards the middle of the
   * patch more than that of body 2. Exchanging the bodies changes the sign, and
   * zero means that normal and tangential contact are uncoupled. E in Pa; a
   * rigid body has E = infinity.
   */
  double dundurs_beta(const double young_modulus_1,
                      const double poisson_ratio_1,
                      const double young_modulus_2,
                      const double poisson_ratio_2);

  /**
   * Relative radius R (m) of two profiles, 1/R = 1/R1 + 1/R2. A flat profile
   * has R = infinity, a concave one R < 0; the sum must be positive.
   */
  double relative_radius(const double radius_1, const double radius_2);

  /**
   * Elasticity of the pair in tangential contact: G in Pa, nu.
   */
  struct CombinedElasticity
  {
    double shear_modulus;
    double poisson_ratio;
  };

  /**
   * Combined elasticity of two bodies, 1/G = (1/G1 + 1/G2)/2 and nu/G = (nu1/G1
   * + nu2/G2)/2 (Kalker 1990), so that E* = G/(1-nu). A rigid body has E =
   * infinity.
   */
  CombinedElasticity combined_elasticity(const double young_modulus_1,
                                         const double poisson_ratio_1,
                                         const double young_modulus_2,
                                         const double poisson_ratio_2);
} // namespace RollingContact::References

#endif
