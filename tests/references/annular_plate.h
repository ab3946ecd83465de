#ifndef rolling_contact_tests_references_annular_plate_h
#define rolling_contact_tests_references_annular_plate_h

#include <vector>

namespace RollingContact::References
{
  /**
   * A thin annular plate, clamped at its inner edge and free at its outer one.
   */
  struct AnnularPlate
  {
    double inner_radius  = 0.08; ///< m
    double outer_radius  = 0.46;
    double thickness     = 0.02;
    double young_modulus = 210e9; ///< Pa
    double poisson_ratio = 0.3;
    double density       = 7850.; ///< kg/m^3

    /**
     * The lowest bending frequencies with so many nodal diameters, ascending,
     * by Kirchhoff's theory: w = (A J_n + B Y_n + C I_n + D K_n)(k r) cos n
     * theta, w = w' = 0 inside, bending moment and Kirchhoff's shear zero
     * outside, f = k^2 sqrt(D / (rho t)) / (2 pi) (Leissa 1969). Units: Hz.
     */
    std::vector<double> frequencies(const unsigned int n_diameters,
                                    const unsigned int n_frequencies) const;
  };
} // namespace RollingContact::References

#endif
