#ifndef rolling_contact_algebra_block_lanczos_h
#define rolling_contact_algebra_block_lanczos_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/algebra/symmetric_sparse_matrix.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * What is asked of block_lanczos().
   */
  struct LanczosControls
  {
    double largest = 0.; ///< eigenvalues up to this one are wanted

    /** Added to the problem, A = K + shift M, so that A is positive definite.
     */
    double shift = 0.;

    /**
     * Bound of the residual || A^-1 M x - theta x || over theta = 1 / (lambda +
     * shift), in the norm of M.
     */
    double tolerance = 1e-10;

    /** How many are wanted, if that is known: then it goes on until it has
     * so many. */
    std::optional<std::size_t> number = {};

    unsigned int  block_size = 8;
    std::uint64_t seed       = 1; ///< of the first block

    /** Called after every block; throws to stop. */
    std::function<void()> interrupt = []() {};
  };

  /**
   * Eigenvalues of K x = lambda M x in ascending order, and their vectors as
   * columns, orthonormal in M.
   */
  struct EigenPairs
  {
    std::vector<double> values;
    DenseMatrix         vectors;
    std::size_t         n_solves = 0; ///< of columns
    std::size_t         n_basis  = 0; ///< largest dimension of the Krylov space
  };

  /**
   * All eigenpairs of K x = lambda M x with lambda <= controls.largest, from
   * the factor of A = K + shift M, by block Lanczos on A^-1 M in the inner
   * product of M with full reorthogonalisation: T = V^T M A^-1 M V is block
   * tridiagonal, its eigenvalues theta approach 1 / (lambda + shift) from the
   * largest on (Grimes, Lewis, Simon 1994, without restart). A block of right
   * hand sides reads the factor once, which makes a solve three to four times
   * cheaper, and finds eigenvalues as often multiple as it has columns. It ends
   * when all values wanted and the first one beyond have converged. Throws
   * MemoryError if the Krylov space does not fit.
   */
  EigenPairs block_lanczos(const Factorisation         &factor,
                           const SymmetricSparseMatrix &M,
                           const LanczosControls       &controls);
} // namespace RollingContact

#endif
