#ifndef rolling_contact_modes_structural_modes_h
#define rolling_contact_modes_structural_modes_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/algebra/reflection.h>
#include <rolling_contact/algebra/symmetric_sparse_matrix.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * Which modes are wanted, and how exact.
   */
  struct ModeControls
  {
    double cut_off = 10e3; ///< all up to this frequency. Units: Hz

    /**
     * Bound of the residual || K phi - lambda M phi || over lambda || M phi ||,
     * as far as rounding allows.
     */
    double tolerance = 1e-8;

    unsigned int block_size = 8;

    /** Count the eigenvalues below the cut-off by the inertia of a second
     * factor. */
    bool count = true;

    /** Called with that number before any mode is computed; throws to stop. */
    std::function<void(std::size_t)> counted = [](std::size_t) {};

    std::function<void()> interrupt = []() {};
  };

  /**
   * Modes of a structure, K phi_j = (2 pi f_j)^2 M phi_j, with
   * phi_i^T M phi_j = 1 for i = j, else 0.
   */
  struct StructuralModes
  {
    std::vector<double> frequencies; ///< f_j, ascending. Units: Hz
    DenseMatrix         shapes;      ///< phi_j by columns. Units: 1/kg^(1/2)

    /**
     * Where modes are more exact than those of K: fields of K for the first of
     * them, with the compliance that K has in their place, see statics().
     * Units: m/J^(1/2).
     */
    DenseMatrix at_rest;

    /** || K phi - lambda M phi || over lambda || M phi ||; of a rigid mode over
     * the lambda of the cut-off. */
    std::vector<double> residuals;

    double orthogonality = 0.; ///< largest |phi_i^T M phi_j - delta_ij|
    double cut_off       = 0.; ///< Hz

    /** Eigenvalues below the cut-off by inertia. */
    std::optional<std::size_t> counted;

    std::size_t n_solves        = 0; ///< of columns
    std::size_t n_subspaces     = 1; ///< in which modes were looked for
    std::size_t n_basis         = 0; ///< of the largest Krylov space, columns
    std::size_t basis_bytes     = 0; ///< of the largest Krylov space
    double      lanczos_seconds = 0.;
    double      count_seconds   = 0.;

    std::size_t size() const
    {
      return frequencies.size();
    }

    /** Eigenvalue (2 pi f_j)^2. Units: 1/s^2. */
    double eigenvalue(const std::size_t j) const;

    /**
     * L^T R of motions L^T x, R R^T being the part of (K + shift M)^-1 that the
     * modes take: R = Phi (Lambda + shift)^(-1/2), but at_rest for the first of
     * them. From L^T Phi and L^T at_rest. Units: m/J^(1/2), 1/s^2.
     */
    DenseMatrix statics(const DenseMatrix &motions,
                        const DenseMatrix &motions_at_rest,
                        const double       shift = 0.) const;

    /** Replace at_rest by fields of K + shift M for the modes up to a frequency
     * (Hz): one inverse iteration, orthonormal in K + shift M. */
    void find_at_rest(const SymmetricSparseMatrix &K,
                      const SymmetricSparseMatrix &M,
                      const Factorisation         &factor,
                      const double                 shift,
                      const double                 highest);
  };

  /**
   * Added to K for a body that nothing holds, times M, so that it is positive
   * definite: (2 pi f)^2 of a fiftieth of the cut-off. Units: 1/s^2.
   */
  double shift_of_free_body(const double cut_off);

  /**
   * All modes up to the cut-off, from the factor of K + shift M. With
   * @p reflections that change neither K nor M, modes are even or odd under
   * each: they are found in one invariant subspace after the other, with a
   * factor of its own for each and without the one given. Throws
   * ConvergenceError if the inertia counts others than were found.
   */
  StructuralModes
  structural_modes(const SymmetricSparseMatrix     &K,
                   const SymmetricSparseMatrix     &M,
                   const Factorisation             &factor,
                   const double                     shift,
                   const std::vector<unsigned int> &node_of_unknown,
                   const ModeControls              &controls,
                   const std::vector<Reflection>   &reflections = {});
} // namespace RollingContact

#endif
