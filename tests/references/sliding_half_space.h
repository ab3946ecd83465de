#ifndef rolling_contact_tests_references_sliding_half_space_h
#define rolling_contact_tests_references_sliding_half_space_h

#include <complex>
#include <vector>

namespace RollingContact::References
{
  /**
   * The surface waves exp(i kappa (x - c t)) that grow on an elastic half-space
   * which slides on a rigid flat without separation, under constant friction
   * (Martins, Guimaraes and Faria 1995; Adams 1995, there of two half-spaces):
   * the phase velocities c over that of shear waves c_2, with Im c > 0, Re c >=
   * 0, in either sense of sliding, of
   *
   *   i a (1 - b^2) +- mu [(1 + b^2) - 2 a b] = 0,
   *   a^2 = 1 - c^2 / c_1^2,  b^2 = 1 - c^2 / c_2^2,  Re a, b > 0.
   *
   * The growth, kappa Im c, has no bound for short waves: where there is a
   * root, elements find what their size lets them. None at mu of railways.
   * Throws InputError unless mu >= 0 and -1 < nu < 1/2.
   */
  std::vector<std::complex<double>>
  growing_sliding_waves(const double mu, const double poisson_ratio);
} // namespace RollingContact::References

#endif
