#ifndef rolling_contact_stability_pencil_h
#define rolling_contact_stability_pencil_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/stability/linear_contact.h>
#include <rolling_contact/stability/reduced_pair.h>

namespace RollingContact
{
  /**
   * An eigenvalue s of a rolling state, disturbances of which go as exp(s t),
   * and the motion that belongs to it.
   */
  struct StabilityMode
  {
    std::complex<double> s; ///< 1/s

    ComplexVector modal;    ///< eta: sum |eta|^2 = 1 if there are modes
    ComplexVector unknowns; ///< x of the LinearContact, Pa

    double residual = 0.; ///< of the scaled pencil, relative

    /**
     * |Im s| / 2 pi. Units: Hz.
     */
    double frequency() const;

    /**
     * Re s; unstable where positive. Units: 1/s.
     */
    double growth() const
    {
      return s.real();
    }

    /**
     * -Re s / |s|; -1 for a real positive s.
     */
    double damping_ratio() const;

    /**
     * True for a real s: the contact itself, no vibration.
     */
    bool is_real() const
    {
      return s.imag() == 0.;
    }

    /**
     * |eta_k|^2 of each mode: the share of it in the kinetic energy. The sum is
     * 1.
     */
    std::vector<double> participation() const;
  };

  /**
   * The first-order equations A x = (s / w) E x of a pair and a linearised
   * contact, x = (eta, eta' / w, y / scale), of order 2 m + n_x, where
   * (1 + tau s) y are tractions and pressures of the contact, y itself what
   * else it has:
   *
   *   A = [        0          I                        0                    ]
   *       [ -K_m / w^2   -C_m / w        Phi^T forces scale / w^2           ]
   *       [   N_u Phi     N_v Phi w   (N_u W_res forces + N_r) scale        ]
   *   E = [ I   0                     0                                     ]
   *       [ 0   I       -tau Phi^T forces scale / w                         ]
   *       [ 0   0   -(N_v W_res forces + N_s + tau N_r') scale w            ],
   *
   * N_r' the columns of tractions and pressures of N_r. Rows of the contact are
   * divided by their largest entries; w is a fifth of the highest frequency and
   * scale the pressure that moves the modes as they move.
   */
  class StabilityPencil
  {
  public:
    /**
     * Throws InputError if pair and contact do not have the same nodes; see
     * also check() of the pair.
     */
    StabilityPencil(const ReducedPair &pair, const LinearContact &contact);

    /**
     * All finite eigenvalues, those of greatest growth first; of conjugate
     * pairs the one with positive imaginary part. By a real shift sigma and
     * dgeev of (A - sigma E)^-1 E without the rows of E that are zero, so none
     * is lost; eigenvalues beyond 1e9 of the nearest one count as infinite,
     * those of the algebraic equations.
     * Units: 1/s.
     */
    ComplexValues eigenvalues() const;

    /**
     * The motion of an eigenvalue by two steps of inverse iteration, and the
     * eigenvalue anew.
     */
    StabilityMode mode(const std::complex<double> s) const;

    std::size_t size() const
    {
      return A.rows();
    }

  private:
    void add_bodies(const ReducedPair &pair, const LinearContact &contact);

    void add_contact(const ReducedPair &pair, const LinearContact &contact);

    std::size_t n_modes     = 0;
    std::size_t n_tractions = 0;
    double      retardation = 0.; ///< s
    double      rate        = 1.; ///< w, 1/s
    double      scale       = 1.; ///< Pa
    DenseMatrix A, E;
  };

  /**
   * The modes of the eigenvalues of @p pencil with growth above @p least_growth
   * (1/s) and frequency below @p greatest_frequency (Hz), by frequency; real
   * ones, which are the contact itself, apart from vibrations.
   */
  struct UnstableModes
  {
    std::vector<StabilityMode> vibrations;
    std::vector<StabilityMode> real;
  };

  UnstableModes unstable_modes(const StabilityPencil &pencil,
                               const double           greatest_frequency,
                               const double           least_growth = 0.);
} // namespace RollingContact

#endif
