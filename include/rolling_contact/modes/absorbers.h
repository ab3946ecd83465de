#ifndef rolling_contact_modes_absorbers_h
#define rolling_contact_modes_absorbers_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/mesh/absorber_ring.h>

#include <vector>

namespace RollingContact
{
  /**
   * Motions of a body of revolution that rings of absorbers follow: of ring
   * after ring the Fourier coefficients of its motion w along the direction of
   * the absorbers round the circle,
   *
   *   W_0 = mean of w,    W_dc, W_ds = mean of w sqrt(2) cos, sin (d theta),
   *
   * d = 1 ... D, so that the mean of w^2 is the sum of their squares. n equal
   * absorbers at equal angles see no other than these as long as w has no more
   * than D < n/2 nodal diameters, wherever they have turned to: then they are a
   * continuous ring. A motion is W = L^T x of the unknowns x of the body.
   */
  struct AbsorberPlaces
  {
    std::vector<unsigned int> diameters; ///< D of each ring
    DenseMatrix               loads;     ///< L, unknowns x c, 1
    DenseMatrix               deflected; ///< K^-1 L, unknowns x c, m/N
    DenseMatrix motions; ///< P = L^T Phi of the modes, c x m, 1/sqrt(kg)
    DenseMatrix statics; ///< StructuralModes::statics() of them, c x m

    /** R = L^T K^-1 L - P Lambda^-1 P^T, what the modes leave out, c x c,
     * m/N. */
    DenseMatrix residual;

    /** c, of all rings. */
    std::size_t n_coordinates() const;
  };

  /**
   * Hang absorbers on the modes of a body that turns at @p rate under the place
   * it is looked at from: with z of unit mass, the motion of the masses of a
   * ring of n being z / sqrt(n m), and its elongation e = z / sqrt(n m) - P
   * eta,
   *
   *   z'' + 2 Omega T z' + Omega^2 T^2 z + f / sqrt(n m) = 0,
   *   eta'' + C_m eta' + K_m eta - P^T f = 0,
   *   f = K_s e + C_s (e' + Omega T e),     k = n m omega_0^2,
   *   K_s = (1/k + R)^-1,     C_s = 2 zeta / omega_0 K_s k^-1 K_s,
   *
   * T the derivative by the angle, skew: T_dc,ds = d. R, in series with the
   * springs, is exact for a dashpot that is weak against them. @p K_m and @p
   * C_m get rows and columns of z behind their own. Centrifugal and Coriolis
   * forces of radial and circumferential absorbers, of the order of Omega /
   * omega_0, are left out. Units: rad/s, 1/s^2, 1/s.
   */
  void hang_absorbers(const AbsorberPlaces            &places,
                      const std::vector<AbsorberRing> &rings,
                      const double                     rate,
                      DenseMatrix                     &K_m,
                      DenseMatrix                     &C_m);

  /**
   * Let absorbers and forces f_n at other places of the body know of each other
   * by what the modes leave out, @p cross = R_n = N^T K^-1 L - N^T Phi
   * Lambda^-1 P^T, with u = N^T x the motion there: the elongation is
   * z / sqrt(n m) - P eta - R_n^T f_n, so that
   *
   *   u = (Phi_n - R_n K_s P) eta + R_n K_s z / sqrt(n m)
   *       + (W_res - R_n K_s R_n^T) f_n,
   *
   * in which the dashpots are left out. @p shapes: Phi_n of the body's modes,
   * of all of which and of z it gets the columns; @p residual: W_res. Units:
   * m/N, 1/sqrt(kg), m/N.
   */
  void join_absorbers(const AbsorberPlaces            &places,
                      const std::vector<AbsorberRing> &rings,
                      const DenseMatrix               &cross,
                      DenseMatrix                     &shapes,
                      DenseMatrix                     &residual);

  /**
   * z of absorbers that follow the body at rest, sqrt(n m) (P eta + @p
   * left_out) with what the modes leave out of their motion: springs that carry
   * nothing. Units: m, m kg^(1/2).
   */
  std::vector<double> absorbers_at_rest(const AbsorberPlaces            &places,
                                        const std::vector<AbsorberRing> &rings,
                                        const std::vector<double>       &eta,
                                        const std::vector<double> &left_out);

  /**
   * Dynamic stiffness Z(s) of rings, which take Z W from the body where it
   * moves by W exp(s t): with sigma = s + Omega T, g = k + 2 zeta k / omega_0
   * sigma,
   *
   *   Z = g - g (n m sigma^2 + g)^-1 g.
   *
   * Units: rad/s, 1/s to N/m.
   */
  ComplexMatrix absorber_stiffness(const AbsorberPlaces            &places,
                                   const std::vector<AbsorberRing> &rings,
                                   const double                     rate,
                                   const std::complex<double>       s);

  /**
   * Receptances with what hangs on a structure: @p alpha without it, of n
   * places and then of the motions L^T x, with
   * Z of absorber_stiffness(); those of the n places are
   *
   *   alpha - alpha_nL (1 + Z alpha_LL)^-1 Z alpha_Ln.
   *
   * Units: m/N, N/m.
   */
  ComplexMatrix receptances_with(const ComplexMatrix &alpha,
                                 const ComplexMatrix &Z,
                                 const std::size_t    n);

  /**
   * The largest part by which the compliance that the modes leave out softens
   * the springs of the absorbers, of k R. Units: 1.
   */
  double softening(const AbsorberPlaces            &places,
                   const std::vector<AbsorberRing> &rings);
} // namespace RollingContact

#endif
