#ifndef rolling_contact_references_wavy_carter_h
#define rolling_contact_references_wavy_carter_h

#include <complex>
#include <vector>

namespace RollingContact::References
{
  /**
   * A rolling line contact with a wave on the surface of one body. Material
   * flows in +x, the leading edge is x = -a. The wave z exp(i (w t - k x)) is
   * positive out of its body, w = k V. The displacement of the wheel relative
   * to the rail is K[q] + alpha_t T, with half-planes of equal elasticity up to
   * a reference length L and the bodies beyond it:
   *   K[q](x) = -2/(pi E*) int q(s) ln(|x - s|/L) ds;
   * the approach loses K[p] + alpha N by the pressure. E* is that of
   * hertz_line(): 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
   */
  struct WavyLineContact
  {
    double half_width;           ///< a, m
    double relative_radius;      ///< R, m
    double contact_modulus;      ///< E*, Pa
    double reference_length;     ///< L, m, larger than a/2
    double friction_coefficient; ///< mu
    double creepage;             ///< xi > 0, wheel over rail in +x
    double wear_coefficient;     ///< k_w, volume per frictional energy, m^3/J
    double wave_number;          ///< k, 1/m
    /** alpha, answer exp(i w t) of both bodies to the load, m^2/N */
    std::complex<double> normal_compliance = 0.;
    /** alpha_t, to the tangential force on the wheel, m^2/N */
    std::complex<double> tangential_compliance = 0.;
  };

  /**
   * Growth of a wave in a passage, relative to the wave, in its two parts:
   *   slip     = -k_w mu int p_0 s^ exp(i k x) dx,
   *   pressure = -k_w mu int p^ s_0 exp(i k x) dx.
   * The wave grows if the real part of the sum G is positive; its crests move
   * by Im G/k along +x in a passage. In a small slip zone the parts nearly
   * cancel, a share xi R/(mu a) of them is left.
   */
  struct PassageGrowth
  {
    std::complex<double> total() const;

    std::complex<double> slip;
    std::complex<double> pressure;
  };

  /**
   * Carter's steady rolling contact, disturbed by a small wave on the surface,
   * in closed form: non-steady tangential contact, with a leading edge and a
   * stick zone that move. All disturbances are per unit wave, the factor of
   * z exp(i w t). A pressure with inverse square roots at both ends,
   *   p^ = sum c_n T_n(x/a)/sqrt(1 - x^2/a^2),
   *   c_0 = N^/(pi a), c_n = (E* n/a) (-i)^n J_n(k a),
   * fits the wave. The traction on the wheel is q^ = -(mu p^ - q2^); q2^ has
   * the form of p^ on the stick zone of the half-width a' = a - xi R/mu at the
   * leading edge and fits B exp(-i k x) - mu alpha N^ - alpha_t T^ there. B
   * follows from the motion of the leading edge, where q^/p^ of the singular
   * parts is q_0/p_0. Where all slides, q^ = -mu p^. Derived here; in
   * long waves -k_w N^ d(|T| xi)/dN of Carter's steady contact, the real part
   * 4e-6 off at k a = 1e-3.
   *
   * Throws an InputError where a, R, E*, mu, xi or k is not positive (without
   * creepage or friction nothing wears), k_w is negative, L is a/2 or less, a
   * compliance is not finite or cancels that of the contact, or k a > 1000.
   */
  class WavyCarter
  {
  public:
    /**
     * The sums and the quadrature are fine enough for rounding; @p fineness
     * multiplies their numbers of terms and points, to see that they are.
     */
    explicit WavyCarter(const WavyLineContact &contact,
                        const unsigned int     fineness = 1);

    /**
     * Half-width of the steady stick zone, a' = a - xi R/mu (m), zero where all
     * slides.
     */
    double stick_half_width() const;

    /**
     * Amplitude of the load N^ (N/m per m), see load_per_wave().
     */
    std::complex<double> load() const;

    /**
     * Amplitude of the tangential force on the wheel (N/m per m),
     * T^ = -(mu N^ - int q2^ dx).
     */
    std::complex<double> force() const;

    /**
     * Amplitude of the pressure p^(x) (Pa/m) within the patch, zero outside.
     */
    std::complex<double> pressure(const double x) const;

    /**
     * Amplitude of the traction on the wheel q^(x) (Pa/m) within the patch,
     * zero outside. It is singular at both ends of the stick zone.
     */
    std::complex<double> traction(const double x) const;

    /**
     * Amplitude of the relative slip (1/m), in the steady slip zone
     *   s^ = i k (mu alpha N^ + alpha_t T^) + (d/dx + i k) K[q2^],
     * sliding speed over rolling speed. Zero elsewhere.
     */
    std::complex<double> slip(const double x) const;

    /**
     * Growth of the wave in a passage, by the points of Chebyshev in the steady
     * slip zone, whose ends have inverse square roots.
     */
    PassageGrowth growth() const;

  private:
    struct Place;

    void                 solve_pressure();
    void                 solve_stick_zone();
    Place                place_at(const double x) const;
    std::complex<double> pressure_at(const Place &place) const;
    std::complex<double> slip_at(const Place &place) const;
    unsigned int         n_points() const;

    WavyLineContact                   contact;
    unsigned int                      fineness;
    double                            stick_width;
    std::complex<double>              load_amplitude, force_amplitude;
    std::vector<std::complex<double>> pressure_terms, stick_terms;
  };

  /**
   * Amplitude of the load under a unit wave (N/m per m),
   *   N^ = J_0(k a)/(C_H + alpha),  C_H = 2/(pi E*) ln(2 L/a);
   * in time the load rises by the real part of N^ r exp(i w t). Units: m, Pa,
   * m, 1/m, m^2/N. Throws an InputError where an argument is not positive, L is
   * a/2 or less, or alpha is not finite or -C_H.
   */
  std::complex<double> load_per_wave(const double half_width,
                                     const double contact_modulus,
                                     const double reference_length,
                                     const double wave_number,
                                     const std::complex<double> compliance);

  /**
   * Tangential force without slip under a creepage xi exp(i w t) over its
   * steady value F = -pi a E* xi/2, at k = w/V, z = k a:
   *   (J_0 + i J_1)/(J_0 + i z ln(2 L/a) (J_0 + i J_1)).
   * 1 at k = 0. Units: m, m, 1/m. Throws an InputError where a is not positive,
   * L is a/2 or less or k is negative.
   */
  std::complex<double> creepage_wave_ratio(const double half_width,
                                           const double reference_length,
                                           const double wave_number);

  /**
   * The pressure that flattens the wave, S(z) = sum n J_n(z)^2 over n = 1, 2,
   * ...,
   *   S = z/2 [z (J_0^2 + J_1^2) - J_0 J_1],
   * with which int p^ exp(i k x) dx = pi E* S + N^ J_0, z = k a >= 0. Throws an
   * InputError where z is negative.
   */
  double wave_flattening(const double z);

  /**
   * Derivative of the growth of a wave in a passage by the creepage where all
   * slides (xi > mu a/R), which is the growth over the creepage at large ones:
   *   dG/dxi = -k_w mu [pi E* S(k a) + J_0(k a) N^].
   * It depends neither on the creepage nor on alpha_t. Throws as WavyCarter.
   */
  std::complex<double>
  sliding_growth_per_creepage(const WavyLineContact &contact);
} // namespace RollingContact::References

#endif
