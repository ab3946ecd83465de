#ifndef rolling_contact_linear_algebra_block_products_h
#define rolling_contact_linear_algebra_block_products_h

#include <rolling_contact/linear_algebra/dense_matrix.h>

#include <algorithm>
#include <vector>

namespace RollingContact
{
  /**
   * A X of a sparse matrix, which multiplies vectors, and a block of columns.
   */
  template <class Matrix>
  DenseMatrix
  times(const Matrix &A, const DenseMatrix &X)
  {
    const std::size_t   n = X.n_rows();
    DenseMatrix         result(n, X.n_columns());
    std::vector<double> column(n), image(n);
    for (std::size_t j = 0; j < X.n_columns(); ++j)
      {
        std::copy_n(X.data() + j * n, n, column.begin());
        A.multiply(column, image);
        std::copy(image.begin(), image.end(), result.data() + j * n);
      }
    return result;
  }



  /**
   * A B and A^T B by dgemm.
   */
  DenseMatrix
  dense_product(const DenseMatrix &A, const DenseMatrix &B);

  DenseMatrix
  transposed_product(const DenseMatrix &A, const DenseMatrix &B);

  /**
   * X^T A X of a sparse matrix; empty if A is.
   */
  template <class Matrix>
  DenseMatrix
  projected(const Matrix &A, const DenseMatrix &X)
  {
    return A.size() == 0 ? DenseMatrix() : transposed_product(X, times(A, X));
  }
} // namespace RollingContact

#endif
