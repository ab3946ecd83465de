#ifndef rolling_contact_linear_algebra_dense_eigenvalues_h
#define rolling_contact_linear_algebra_dense_eigenvalues_h

#include <rolling_contact/linear_algebra/complex_matrix.h>

namespace RollingContact
{
  /**
   * A B by dgemm.
   */
  DenseMatrix
  operator*(const DenseMatrix &A, const DenseMatrix &B);

  DenseMatrix
  transposed(const DenseMatrix &A);

  /**
   * Eigenvalues of a general real matrix and, if asked for, its right
   * eigenvectors in columns.
   */
  struct Eigenpairs
  {
    ComplexVector values;
    ComplexMatrix vectors;
  };

  /**
   * All eigenvalues of a general real matrix by the QR algorithm (dgeev).
   * Throws ConvergenceError if it does not converge.
   */
  ComplexVector
  eigenvalues(DenseMatrix M);

  /**
   * The same with the right eigenvectors, each of Euclidean norm 1.
   */
  Eigenpairs
  eigenpairs(DenseMatrix M);

  /**
   * The eigenvalues of a symmetric matrix, ascending, of which the lower
   * triangle is read (dsyev).
   */
  std::vector<double>
  symmetric_eigenvalues(DenseMatrix M);

  /**
   * The left singular vectors of @p M in the columns of the result, and its
   * singular @p values, largest first (dgesvd).
   */
  DenseMatrix
  left_singular_vectors(DenseMatrix M, std::vector<double> &values);

  /**
   * The right singular vector of the smallest singular value of a matrix with
   * at least as many rows as columns (zgesvd).
   */
  ComplexVector
  smallest_singular_vector(ComplexMatrix M);
} // namespace RollingContact

#endif
