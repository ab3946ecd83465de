#ifndef rolling_contact_tests_references_timoshenko_rail_h
#define rolling_contact_tests_references_timoshenko_rail_h

#include <complex>

namespace RollingContact::References
{
  /**
   * An infinite Timoshenko beam on a Winkler foundation with hysteretic
   * damping. The default is a rail 60E1 in vertical bending on stiff pads.
   */
  struct TimoshenkoRail
  {
    double bending_stiffness      = 210e9 * 30.55e-6;     ///< E I, N m^2
    double shear_stiffness        = 0.4 * 81e9 * 7.69e-3; ///< kappa G A, N
    double mass                   = 60.2;                 ///< rho A, kg/m
    double rotary_inertia         = 7850. * 30.55e-6;     ///< rho I, kg m
    double foundation_stiffness   = 3.3e8;                ///< N/m^2
    double foundation_loss_factor = 0.2;
    double loss_factor            = 0.02; ///< of the steel

    /**
     * Deflection at the distance @p x of a unit force exp(i omega t) on the
     * beam, m/N: the inverse Fourier transform of (E I k^2 + kappa G A - rho I
     * omega^2) / D(k) by the residues of the two roots of D above the real
     * axis, D(k) = (kappa G A k^2 + s - rho A omega^2)(E I k^2 + kappa G A -
     * rho I omega^2) - (kappa G A k)^2. Units: Hz, m.
     */
    std::complex<double> receptance(const double frequency,
                                    const double x = 0.) const;
  };
} // namespace RollingContact::References

#endif
