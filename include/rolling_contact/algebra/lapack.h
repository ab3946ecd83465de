#ifndef rolling_contact_algebra_lapack_h
#define rolling_contact_algebra_lapack_h

#include <rolling_contact/algebra/dense_matrix.h>

namespace RollingContact
{
  /** The columns of right-hand sides, replaced by solutions. */
  using Columns = Eigen::Ref<DenseMatrix>;

  /**
   * Solve M X = B in place of @p right_hand_sides by Cholesky (dposv), @p M
   * symmetric positive definite and destroyed. Returns false when M is not
   * positive definite.
   */
  bool solve_positive_definite(DenseMatrix &M, Columns right_hand_sides);

  /**
   * Solve M X = B in place for a positive definite band matrix (dpbsv): column
   * j of @p band holds the entries of M from the diagonal down.
   */
  bool solve_positive_definite_band(DenseMatrix &band,
                                    Columns      right_hand_sides);

  /**
   * Solve M X = B in place of @p right_hand_sides by LU (dgesv), @p M
   * destroyed. Returns false when M is singular.
   */
  bool solve_general(DenseMatrix &M, Columns right_hand_sides);

  /**
   * Least-squares solution of M x = b by QR (dgels) for a matrix of full rank
   * with at least as many rows as columns, @p M destroyed. Returns false when M
   * has no full rank.
   */
  bool solve_least_squares(DenseMatrix         &M,
                           std::vector<double> &right_hand_side);

  /**
   * The LU factors of a square complex matrix (zgetrf): solutions of systems
   * and the determinant.
   */
  class ComplexLU
  {
  public:
    explicit ComplexLU(ComplexMatrix M);

    /**
     * True if a pivot is zero or no number: nothing can be solved then.
     */
    bool singular() const
    {
      return is_singular;
    }

    /**
     * Solve M X = B in place.
     */
    void solve(Eigen::Ref<ComplexMatrix> B) const;

    /**
     * ln det M, its imaginary part in (-pi, pi]; minus infinity if singular.
     */
    std::complex<double> log_determinant() const;

  private:
    ComplexMatrix    factors;
    std::vector<int> pivots;
    bool             is_singular = false;
  };

  /**
   * All eigenvalues of a symmetric matrix in ascending order (dsyevd), of which
   * the lower triangle is read. These functions throw ConvergenceError if
   * nothing is found.
   */
  std::vector<double> symmetric_eigenvalues(DenseMatrix M);

  /**
   * Eigenvalues of a symmetric matrix, ascending, with their orthonormal
   * vectors in the columns of @p M.
   */
  std::vector<double> symmetric_eigenpairs(DenseMatrix &M);

  /**
   * All eigenvalues of a general real matrix by the QR algorithm (dgeev).
   */
  ComplexValues eigenvalues(DenseMatrix M);

  /**
   * Eigenvalues of a general real matrix and their right eigenvectors in
   * columns, each of Euclidean norm 1.
   */
  struct Eigenpairs
  {
    ComplexValues values;
    ComplexMatrix vectors;
  };

  Eigenpairs eigenpairs(DenseMatrix M);

  /**
   * Eigenvalues and right eigenvectors of a general complex matrix (zgeev).
   */
  Eigenpairs eigenpairs(ComplexMatrix M);

  /**
   * The left singular vectors of @p M in the columns of the result, and its
   * singular @p values, largest first (dgesvd).
   */
  DenseMatrix left_singular_vectors(DenseMatrix M, std::vector<double> &values);

  /**
   * The right singular vector of the smallest singular value of a matrix with
   * at least as many rows as columns (zgesvd).
   */
  ComplexVector smallest_singular_vector(ComplexMatrix M);
} // namespace RollingContact

#endif
