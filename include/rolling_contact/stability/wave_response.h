#ifndef rolling_contact_stability_wave_response_h
#define rolling_contact_stability_wave_response_h

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/stability/contact_response.h>
#include <rolling_contact/stability/correction.h>

#include <vector>

namespace RollingContact
{
  /**
   * A contact's answer to a passing wave: amplitudes that go as exp(s t).
   */
  struct WaveAnswer
  {
    ComplexVector unknowns; ///< x of the LinearContact, Pa for a wave in m
    ComplexVector motion;   ///< u, W(s) forces x at all nodes, (T + 1) N, m
  };

  /**
   * How rolling at a speed V answers a small wave on the surface of a body,
   * z = exp(-i k X), X = x - V t fixed to its material, which passes the nodes
   * as exp(s t - i k x_i), s = i k V:
   *
   *   T(s) x = b,   T = (N_u + s N_v) W(s) forces + N_r + s N_s,
   *   W(s) = W_res / (1 + tau s) + Phi (K_m + s C_m + s^2)^-1 Phi^T,
   *   b_i = exp(-i k x_i) in the normal rows, 0 elsewhere,
   *
   * with x_i along the flow and the gap u_n - z, z > 0 out of either body. What
   * varies within the patch and within the time that the material takes through
   * it is in T: no contact filter and no steady law of creepage are assumed.
   *
   * Modes move the patch in few independent ways U: a factor of T without modes
   * serves all speeds of a wave number, as its rows depend on V by a factor and
   * by tau, and steps of correction take what that leaves.
   */
  class WaveResponse
  {
  public:
    /**
     * T without modes at s, and the answers A^-1 (N_u + s N_v) U.
     */
    struct Factors
    {
      ComplexLU     contact;
      ComplexMatrix motions;
    };

    /**
     * The few independent motions of the patch by modes, orthonormal columns.
     */
    static DenseMatrix motions_of(const ReducedPair &pair);

    /**
     * @p along: places of the touching nodes of @p contact along the flow, m;
     * @p speed: V of the contact and of @p pair, m/s; @p motions: those of a
     * pair with these modes, see motions_of(). Keeps references to both.
     */
    WaveResponse(const LinearContact &contact,
                 const ReducedPair   &pair,
                 const double         speed,
                 std::vector<double>  along,
                 const DenseMatrix   &motions);

    /** U^T Phi, p x m. */
    const DenseMatrix &motions_of_coordinates() const
    {
      return amplitudes;
    }

    /** s = i k V. Units: 1/m, 1/s. */
    std::complex<double> rate(const double wave_number) const
    {
      return {0., wave_number * speed};
    }

    /** Throws ConvergenceError if T without modes is singular. Units: 1/m. */
    Factors factors(const double wave_number) const;

    /** What waves over other nodes of the same bodies share. Units: 1/m. */
    ModalFactors modal(const double wave_number) const
    {
      return ModalFactors(pair, rate(wave_number));
    }

    /** b of a wave; with a second wave number 0 of the same s the patch moves
     * as one. Units: 1/m, m. */
    ComplexVector height_wave(const double wave_number) const;

    /**
     * How the patch reacts to amplitudes a of its motions U and to waves: the
     * generalised forces U^T forces x, in one row more the normal load, and in
     * further ones those on the pair's watched motions, are of_waves -
     * by_motions a.
     */
    struct Reaction
    {
      ComplexMatrix by_motions; ///< rows x p, N/m
      ComplexMatrix of_waves;   ///< rows x J, N/m
    };

    /** Waves: b of the normal rows alone, n_a x J, m. Throws ConvergenceError.
     * Units: 1/m. */
    Reaction reaction(const double         wave_number,
                      const Factors       &factors,
                      const ComplexMatrix &waves) const;

    /**
     * Answers at one wave number, with factors of it at any speed. Keeps
     * references to the response and to these.
     */
    class AtWave
    {
    public:
      /** @p modal: those of the bodies at s. Units: 1/m. */
      AtWave(const WaveResponse &response,
             const double        wave_number,
             const Factors      &factors,
             const ModalFactors &modal);

      /** The answer to @p b. Throws ConvergenceError if none is found. */
      WaveAnswer answer(const ComplexVector &b) const;

      /**
       * The answer to @p b with the whole bodies, of which @p bodies answers
       * nodal forces: steps x += T^-1 (b - T_full x) from that of the modes, so
       * many.
       */
      WaveAnswer corrected(const ComplexVector &b,
                           const BodyResponse  &bodies,
                           const unsigned int   n_steps) const;

      /** The unknowns of the answer to @p b alone. */
      ComplexVector unknowns(const ComplexVector &b) const;

      /** How modes answer forces on the motions U, U^T Phi D^-1 Phi^T U. Units:
       * m/N. */
      const ComplexMatrix &response_of_motions() const
      {
        return response;
      }

      /** 1 + tau s. */
      std::complex<double> retardation() const
      {
        return delay;
      }

    private:
      /** W(s) of nodal forces. Units: N to m. */
      ComplexVector motion_under(const ComplexVector &forces) const;

      /** T y and, nearly, T^-1 r, rows scaled; y (1 + tau s) are tractions. */
      ComplexVector product(const ComplexVector &y) const;
      ComplexVector nearly_solved(ComplexVector r) const;

      const WaveResponse        &of;
      const Factors             &factors;
      const std::complex<double> s, delay; ///< delay = 1 + tau s
      ComplexMatrix              response; ///< of the motions U, p x p
      ComplexMatrix              reaction; ///< delay U^T forces, p x n_x
      ComplexLU                  joined;
    };

  private:
    /** Rows of T have units of their own; scale them to the largest entry. */
    void scale_rows();

    const LinearContact &contact;
    const ReducedPair   &pair;
    double               speed;
    std::vector<double>  along;
    ResidualContact      residual;
    DenseMatrix          U, amplitudes; ///< (T + 1) N x p, p x m
    DenseMatrix          N_u, N_v;      ///< N_u U and N_v U, scaled
    Eigen::VectorXd      scales;        ///< of the rows
  };
} // namespace RollingContact

#endif
