#ifndef rolling_contact_tests_references_two_mass_flutter_h
#define rolling_contact_tests_references_two_mass_flutter_h

#include <complex>

namespace RollingContact::References
{
  /**
   * Flutter by mode coupling (Hoffmann et al. 2002): two unit masses of which
   * one slides on a belt under a contact spring of the other, so that constant
   * friction makes the stiffness one-sided,
   *
   *   x'' + C x' + [k11, k12 - mu k3; k12, k22] x = 0,   C = diag(c1, c2).
   *
   * Units: 1/s^2 of stiffness, 1/s of damping.
   */
  struct TwoMassFlutter
  {
    double k11, k22, k12, k3;
    double c1 = 0., c2 = 0.;

    /**
     * The mu from which the steady state is unstable: where both frequencies
     * meet without damping, (k12 + (k11 - k22)^2 / (4 k12)) / k3, else where
     * Hurwitz' determinant vanishes. Throws InputError for damping that is
     * negative, or k12 or k3 that are not positive.
     */
    double critical_friction() const;

    /**
     * The eigenvalue of greatest growth without damping. Units: 1/s.
     */
    std::complex<double> undamped_eigenvalue(const double mu) const;
  };
} // namespace RollingContact::References

#endif
