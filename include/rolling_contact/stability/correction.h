#ifndef rolling_contact_stability_correction_h
#define rolling_contact_stability_correction_h

#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/stability/pencil.h>

#include <functional>

namespace RollingContact
{
  /**
   * The motions of the wheel relative to the rail at all nodes of contact under
   * nodal forces that go as exp(s t), of the full bodies: W_full(s_k) f_k for
   * each k, (T + 1) N complex values each. Units: 1/s, N to m.
   */
  using BodyResponse = std::function<
    std::vector<ComplexVector>(const ComplexValues              &s,
                               const std::vector<ComplexVector> &forces)>;

  struct CorrectionOptions
  {
    /** Answers of the full bodies at most, for each mode. */
    unsigned int most_steps = 4;

    /** Relative to |s|: a correction of no more than this ends the steps. */
    double tolerance = 1e-7;

    /** The damping ratio that a mode should have beyond being stable. */
    double damping_margin = 0.;
  };

  /**
   * An eigenvalue of the reduced equations as the full bodies correct it.
   */
  struct CorrectedMode
  {
    std::complex<double> s;        ///< corrected, 1/s
    std::complex<double> reduced;  ///< as it was, 1/s
    ComplexVector        unknowns; ///< x of the LinearContact, Pa

    /** |last change of s|; infinite where the changes grow. Units: 1/s. */
    double uncertainty = 0.;

    /** ||T_full(s) x|| / || |T| |x| ||, rows scaled to one: of the reduced
     * eigenvalue and vector, and of those before the last change. */
    double first_backward_error = 0.;
    double backward_error       = 0.;

    unsigned int n_responses = 0; ///< answers of the full bodies

    double growth() const
    {
      return s.real();
    }

    /**
     * True where the growth is less than its own uncertainty: neither stable
     * nor unstable is shown then.
     */
    bool undecided() const;

    /**
     * True where the growth is positive beyond its uncertainty.
     */
    bool unstable() const;

    /**
     * The damping ratio that would have to be added to make the mode stable,
     * with the margin asked for; 0 if it is stable with it.
     */
    double damping_needed = 0.;
  };

  /**
   * Eigenvalues and contact vectors of modes by the equations of the full
   * bodies,
   *
   *   T_full(s) x = [(N_u + s N_v) W_full(s) forces + N_r + s N_s] x = 0,
   *
   * which @p response answers, one product T_full x a step: Newton's method
   * with the bordered matrix of the reduced pair at its eigenvalue,
   *
   *   [ T    T' x ] [dx]     [ T_full(s) x ]
   *   [ x^H    0  ] [ds] = - [      0      ].
   *
   * The first step is s - l^H T_full x / (l^H T' x), l the left null vector of
   * T: the correction by one vector. Further ones correct the vector, too. All
   * modes take their steps side by side, so that the full bodies answer a
   * number of them at once; each keeps two dense complex matrices of contact.
   */
  std::vector<CorrectedMode> correct(const ReducedPair                &pair,
                                     const LinearContact              &contact,
                                     const std::vector<StabilityMode> &modes,
                                     const BodyResponse               &response,
                                     const CorrectionOptions &options = {});

  /**
   * Factors of s^2 + s C_m + K_m, with the loss stiffness H_m if there is one,
   * of wheel and rail each.
   */
  class ModalFactors
  {
  public:
    ModalFactors(const ReducedPair &pair, const std::complex<double> s);

    /** Amplitudes of all coordinates by their loads, in place, m x n. */
    void solve(Eigen::Ref<ComplexMatrix> B) const;

  private:
    std::vector<ComplexLU> of_bodies;
    Eigen::Index           n_of_wheel;
  };

  /**
   * W(s) f of the reduced pair.
   */
  ComplexVector reduced_response(const ReducedPair         &pair,
                                 const std::complex<double> s,
                                 const ComplexVector       &forces);
} // namespace RollingContact

#endif
