#ifndef rolling_contact_modes_full_dynamics_h
#define rolling_contact_modes_full_dynamics_h

#include <rolling_contact/linear_algebra/complex_matrix.h>
#include <rolling_contact/linear_algebra/factorisation.h>
#include <rolling_contact/linear_algebra/skew_sparse_matrix.h>
#include <rolling_contact/modes/structural_modes.h>

#include <complex>

namespace RollingContact
{
  /**
   * The matrices of a whole body that may turn about its axle at a rate Omega
   * while it is looked at from where it does not. C and S may be empty. Units:
   * N/m, kg, N s/m, kg, rad/s.
   */
  struct TurningStructure
  {
    const SymmetricSparseMatrix &K, &M, &C;
    const SkewSparseMatrix      &S;
    double                       rate = 0.;
  };

  /**
   * Vibration that goes as exp(s t), of all unknowns of a body:
   *
   *   D(s) x = b,
   *   D = K + s C' + s^2 M + 2 s Omega S + Omega^2 S M_l^-1 S
   *         + Omega C' M_l^-1 S,
   *
   * C' = C + M Phi diag(2 zeta_j omega_j) Phi^T M with the damping ratios of
   * the modes, M_l the diagonal of M. Solved with the real factor of K and the
   * modes alone: x <- x + P^-1 (b - D x),
   *
   *   P^-1 b = Phi [(s^2 + s C_m + K_m)^-1 - Lambda^-1] Phi^T b + K^-1 b,
   *
   * which contracts by |s|^2 over the first eigenvalue beyond the modes.
   */
  class FullDynamics
  {
  public:
    /**
     * Keeps references: all of them must outlive this. @p K_m, @p C_m: of the
     * modes, with damping and rotation.
     */
    FullDynamics(const TurningStructure    &structure,
                 const Factorisation       &factor,
                 const StructuralModes     &modes,
                 const std::vector<double> &damping_ratios,
                 const DenseMatrix         &K_m,
                 const DenseMatrix         &C_m);

    /**
     * x to a relative residual of @p tolerance, or, below 1e-6, as far as
     * rounding allows. Throws ConvergenceError if that
     * is not reached, as when |s| is beyond the modes. Units: 1/s, N to m.
     */
    ComplexVector
    solve(const std::complex<double> s,
          const ComplexVector       &b,
          const double               tolerance) const;

    /** Iterations of all solutions so far, two triangular solves each. */
    unsigned int
    n_iterations() const
    {
      return iterations;
    }

  private:
    ComplexVector
    multiply(const std::complex<double> s, const ComplexVector &x) const;

    ComplexVector
    precondition(const ComplexLU &D_m, const ComplexVector &b) const;

    TurningStructure       structure;
    const Factorisation   &factor;
    const StructuralModes &modes;
    std::vector<double>    modal_damping; ///< 2 zeta omega
    DenseMatrix            K_m, C_m;
    DenseMatrix            M_phi;
    mutable unsigned int   iterations = 0;
  };
} // namespace RollingContact

#endif
