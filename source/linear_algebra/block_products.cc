#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/linear_algebra/block_products.h>

namespace RollingContact
{
  namespace
  {
    DenseMatrix
    product(const char        *transpose,
            const std::size_t  n_rows,
            const std::size_t  n_inner,
            const DenseMatrix &A,
            const DenseMatrix &B)
    {
      DenseMatrix  C(n_rows, B.n_columns());
      const int    m = n_rows, n = B.n_columns(), k = n_inner, lda = A.n_rows();
      const double one = 1., zero = 0.;
      if (m > 0 && n > 0 && k > 0)
        dgemm_(transpose,
               "N",
               &m,
               &n,
               &k,
               &one,
               A.data(),
               &lda,
               B.data(),
               &k,
               &zero,
               C.data(),
               &m);
      return C;
    }
  } // namespace



  DenseMatrix
  dense_product(const DenseMatrix &A, const DenseMatrix &B)
  {
    return product("N", A.n_rows(), A.n_columns(), A, B);
  }



  DenseMatrix
  transposed_product(const DenseMatrix &A, const DenseMatrix &B)
  {
    return product("T", A.n_columns(), A.n_rows(), A, B);
  }
} // namespace RollingContact
