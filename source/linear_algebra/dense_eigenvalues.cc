#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/dense_eigenvalues.h>

#include <algorithm>

namespace RollingContact
{
  DenseMatrix
  operator*(const DenseMatrix &A, const DenseMatrix &B)
  {
    return dense_product(A, B);
  }



  DenseMatrix
  transposed(const DenseMatrix &A)
  {
    DenseMatrix B(A.n_columns(), A.n_rows());
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      for (std::size_t i = 0; i < A.n_rows(); ++i)
        B(j, i) = A(i, j);
    return B;
  }



  namespace
  {
    void
    check(const int info, const std::string &what)
    {
      if (info != 0)
        throw ConvergenceError(
          what + " did not converge (LAPACK: info = " + std::to_string(info) +
          "); the matrix may hold no numbers.");
    }



    /**
     * dgeev; the vectors of conjugate pairs stand in @p vectors as real and
     * imaginary part.
     */
    ComplexVector
    general_eigenvalues(DenseMatrix &M, DenseMatrix *vectors)
    {
      const int           n = M.n_rows(), one = 1, n_work = 34 * n;
      const int           n_vector = vectors ? n : 1;
      int                 info     = 0;
      std::vector<double> real(n), imaginary(n), work(n_work);
      if (n > 0)
        dgeev_("N",
               vectors ? "V" : "N",
               &n,
               M.data(),
               &n,
               real.data(),
               imaginary.data(),
               nullptr,
               &one,
               vectors ? vectors->data() : nullptr,
               &n_vector,
               work.data(),
               &n_work,
               &info);
      check(info, "The QR algorithm for eigenvalues");
      ComplexVector values(n);
      for (int k = 0; k < n; ++k)
        values[k] = {real[k], imaginary[k]};
      return values;
    }
  } // namespace



  ComplexVector
  eigenvalues(DenseMatrix M)
  {
    return general_eigenvalues(M, nullptr);
  }



  Eigenpairs
  eigenpairs(DenseMatrix M)
  {
    const std::size_t n = M.n_rows();
    DenseMatrix       real(n, n);
    Eigenpairs        pairs{general_eigenvalues(M, &real), ComplexMatrix(n, n)};
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        pairs.vectors(i, k) =
          pairs.values[k].imag() == 0. ? std::complex<double>(real(i, k))
          : pairs.values[k].imag() > 0.
            ? std::complex<double>(real(i, k), real(i, k + 1))
            : std::complex<double>(real(i, k - 1), -real(i, k));
    return pairs;
  }



  std::vector<double>
  symmetric_eigenvalues(DenseMatrix M)
  {
    const int           n = M.n_rows(), n_work = 34 * n;
    int                 info = 0;
    std::vector<double> values(n), work(n_work);
    if (n > 0)
      dsyev_(
        "N", "L", &n, M.data(), &n, values.data(), work.data(), &n_work, &info);
    check(info, "The QR algorithm for symmetric eigenvalues");
    return values;
  }



  DenseMatrix
  left_singular_vectors(DenseMatrix M, std::vector<double> &values)
  {
    const int m = M.n_rows(), n = M.n_columns(), one = 1, k = std::min(m, n),
              n_work         = 32 * (m + n);
    int                 info = 0;
    std::vector<double> work(n_work);
    DenseMatrix         U(m, k);
    values.assign(k, 0.);
    if (k > 0)
      dgesvd_("S",
              "N",
              &m,
              &n,
              M.data(),
              &m,
              values.data(),
              U.data(),
              &m,
              nullptr,
              &one,
              work.data(),
              &n_work,
              &info);
    check(info, "The singular value decomposition");
    return U;
  }



  ComplexVector
  smallest_singular_vector(ComplexMatrix M)
  {
    const int m = M.n_rows(), n = M.n_columns(), one = 1, n_work = 32 * (m + n);
    int       info = 0;
    std::vector<double> values(n), real_work(5 * n);
    ComplexVector       work(n_work);
    ComplexMatrix       adjoint(n, n);
    zgesvd_("N",
            "A",
            &m,
            &n,
            M.data(),
            &m,
            values.data(),
            nullptr,
            &one,
            adjoint.data(),
            &n,
            work.data(),
            &n_work,
            real_work.data(),
            &info);
    check(info, "The singular value decomposition");
    ComplexVector vector(n);
    for (int i = 0; i < n; ++i)
      vector[i] = std::conj(adjoint(n - 1, i));
    return vector;
  }
} // namespace RollingContact
