#ifndef rolling_contact_modes_full_dynamics_h
#define rolling_contact_modes_full_dynamics_h

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/algebra/skew_sparse_matrix.h>
#include <rolling_contact/modes/structural_modes.h>

#include <complex>
#include <functional>
#include <optional>

namespace RollingContact
{
  /**
   * The matrices of a whole body that may turn about its axle at a rate Omega
   * while it is looked at from where it does not. C, the loss stiffness H and S
   * may be empty. Units: N/m, kg, N s/m, N/m, kg, rad/s.
   */
  struct TurningStructure
  {
    const SymmetricSparseMatrix &K, &M, &C, &H;
    const SkewSparseMatrix      &S;
    double                       rate = 0.;
  };

  /**
   * What hangs on a few motions W = L^T x of a structure, which is left with
   * the forces -L Z(s) W: L, K^-1 L, what the modes leave out of L^T K^-1 L,
   * P = L^T Phi of the modes and their statics(), see AbsorberPlaces, and Z by
   * s in 1/s. Units: 1, m/N, m/N, 1/sqrt(kg), m/J^(1/2), N/m.
   */
  struct AttachedDynamics
  {
    const DenseMatrix &loads, &deflected, &residual, &motions, &statics;

    std::function<ComplexMatrix(const std::complex<double>)> stiffness;
  };

  /**
   * Vibration that goes as exp(s t), of all unknowns of a body:
   *
   *   D(s) x = b,
   *   D = K + s/|Im s| H + s C' + s^2 M + 2 s Omega S + Omega^2 S M_l^-1 S
   *         + Omega C' M_l^-1 S + L Z(s) L^T,
   *
   * without H where s is real; L Z L^T of what is attached, C' = C + M Phi
   * diag(2 zeta_j omega_j) Phi^T M with the damping ratios of the modes, M_l
   * the diagonal of M. Solved with the real factor of K and the modes alone: x
   * <- x + P^-1 (b - D x),
   *
   *   P^-1 b = Phi [(s^2 + s C_m + K_m)^-1 - Lambda^-1] Phi^T b + K^-1 b,
   *
   * which contracts by |s|^2 over the first eigenvalue beyond the modes. With
   * something attached its inverse is that of P + L Z L^T, by Woodbury's
   * formula.
   */
  class FullDynamics
  {
  public:
    /**
     * Keeps references: all of them must outlive this. @p K_m, @p C_m: of the
     * modes, with damping and rotation, without what is @p attached.
     */
    FullDynamics(const TurningStructure         &structure,
                 const Factorisation            &factor,
                 const StructuralModes          &modes,
                 const std::vector<double>      &damping_ratios,
                 const DenseMatrix              &K_m,
                 const DenseMatrix              &C_m,
                 std::optional<AttachedDynamics> attached = {});

    /**
     * Take P^-1 b for the answer from now on, in which what the modes leave out
     * is a compliance that follows forces with this @p retardation (s): for
     * modes that are not those of K and M but more exact.
     */
    void take_modes(const double retardation)
    {
      retardation_beyond = retardation;
    }

    /**
     * An x for each s and b, to a relative residual of @p tolerance, or, below
     * 1e-6, as far as rounding allows; side by side, so that factor and modes
     * are read once for all of them. Throws ConvergenceError if that is not
     * reached, as when |s| is beyond the modes. Units: 1/s, N to m.
     */
    std::vector<ComplexVector> solve(const ComplexValues              &s,
                                     const std::vector<ComplexVector> &b,
                                     const double tolerance) const;

    /** Iterations of all solutions so far, two triangular solves each. */
    unsigned int n_iterations() const
    {
      return iterations;
    }

  private:
    /**
     * Factors at one complex rate s: (s^2 + s C_m + K_m)^-1 and, for what is
     * attached to the body, Z and (1 + Z L^T P^-1 L)^-1.
     */
    struct AtOneRate
    {
      std::complex<double>     s;
      ComplexLU                modes;
      ComplexMatrix            stiffness;
      std::optional<ComplexLU> woodbury;
    };

    /** Factors of each vector of a block, in its order. */
    using Rates = std::vector<const AtOneRate *>;

    AtOneRate at(const std::complex<double> s) const;

    /** What part of a force the compliance beyond the modes follows, 1 / (1 + s
     * tau); 1 where whole bodies are solved. */
    std::complex<double> part_beyond(const std::complex<double> s) const;

    std::vector<ComplexVector>
    by_modes(const ComplexValues &s, const std::vector<ComplexVector> &b) const;

    /** D(s) X. */
    ComplexMatrix multiply(const Rates &rates, const ComplexMatrix &X) const;

    /** P(s)^-1 B. */
    ComplexMatrix precondition(const Rates         &rates,
                               const ComplexMatrix &B) const;

    /** X <- (X - R @p at_rest) part_beyond + Phi (s^2 + s C_m + K_m)^-1 Q, R of
     * StructuralModes::statics(), from Q = Phi^T B and at_rest = R^T B. */
    void add_modes(const Rates         &rates,
                   ComplexMatrix        Q,
                   const ComplexMatrix &at_rest,
                   ComplexMatrix       &X) const;

    /** Forces of the loss stiffness. */
    void add_losses(const Rates         &rates,
                    const ComplexMatrix &X,
                    ComplexMatrix       &result) const;

    /** Forces of what is attached on the structure, that X has to bear. */
    void add_attached(const Rates         &rates,
                      const ComplexMatrix &X,
                      ComplexMatrix       &result) const;

    /** Forces of the flow, and what it adds to the velocities. */
    void add_flow(const Rates         &rates,
                  const ComplexMatrix &X,
                  ComplexMatrix       &velocities,
                  ComplexMatrix       &result) const;

    TurningStructure       structure;
    const Factorisation   &factor;
    const StructuralModes &modes;
    Eigen::VectorXd        modal_damping; ///< 2 zeta omega
    DenseMatrix            K_m, C_m;

    std::optional<AttachedDynamics> attached;

    /** Set where the modes are taken as they are. */
    std::optional<double> retardation_beyond;

    mutable unsigned int iterations = 0;
  };
} // namespace RollingContact

#endif
