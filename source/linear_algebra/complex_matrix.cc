#include <rolling_contact/base/constants.h>
#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/linear_algebra/complex_matrix.h>

#include <cmath>
#include <limits>

namespace RollingContact
{
  ComplexMatrix::ComplexMatrix(const DenseMatrix         &A,
                               const std::complex<double> s,
                               const DenseMatrix         &B)
    : ComplexMatrix(A.n_rows(), A.n_columns())
  {
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = A.data()[k] + s * B.data()[k];
  }



  ComplexMatrix::ComplexMatrix(const DenseMatrix &A)
    : ComplexMatrix(A.n_rows(), A.n_columns())
  {
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = A.data()[k];
  }



  ComplexMatrix
  operator*(const ComplexMatrix &A, const ComplexMatrix &B)
  {
    ComplexMatrix C(A.n_rows(), B.n_columns());
    const int     m = A.n_rows(), n = B.n_columns(), k = B.n_rows();
    const std::complex<double> one = 1., zero = 0.;
    if (m > 0 && n > 0 && k > 0)
      zgemm_("N",
             "N",
             &m,
             &n,
             &k,
             &one,
             A.data(),
             &m,
             B.data(),
             &k,
             &zero,
             C.data(),
             &m);
    return C;
  }



  ComplexVector
  operator*(const ComplexMatrix &A, const ComplexVector &x)
  {
    ComplexVector y(A.n_rows());
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      for (std::size_t i = 0; i < A.n_rows(); ++i)
        y[i] += A(i, j) * x[j];
    return y;
  }



  ComplexVector
  operator*(const DenseMatrix &A, const ComplexVector &x)
  {
    ComplexVector y(A.n_rows());
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      for (std::size_t i = 0; i < A.n_rows(); ++i)
        y[i] += A(i, j) * x[j];
    return y;
  }



  ComplexVector
  transposed_product(const DenseMatrix &A, const ComplexVector &x)
  {
    ComplexVector y(A.n_columns());
    for (std::size_t j = 0; j < A.n_columns(); ++j)
      for (std::size_t i = 0; i < A.n_rows(); ++i)
        y[j] += A(i, j) * x[i];
    return y;
  }



  void
  add(ComplexVector             &x,
      const std::complex<double> factor,
      const ComplexVector       &y)
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += factor * y[i];
  }



  double
  norm(const ComplexVector &x)
  {
    double sum = 0.;
    for (const auto &value : x)
      sum += std::norm(value);
    return std::sqrt(sum);
  }



  std::complex<double>
  dot(const ComplexVector &x, const ComplexVector &y)
  {
    std::complex<double> sum = 0.;
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += std::conj(x[i]) * y[i];
    return sum;
  }



  ComplexLU::ComplexLU(ComplexMatrix M)
    : factors(std::move(M))
    , pivots(factors.n_rows())
  {
    const int n    = factors.n_rows();
    int       info = 0;
    if (n > 0)
      zgetrf_(&n, &n, factors.data(), &n, pivots.data(), &info);
    is_singular = info != 0;
    for (int i = 0; i < n; ++i)
      if (!std::isfinite(std::abs(factors(i, i))))
        is_singular = true;
  }



  void
  ComplexLU::solve(const char                  kind,
                   const int                   n_columns,
                   std::complex<double> *const right_hand_sides) const
  {
    const int n    = factors.n_rows();
    int       info = 0;
    if (n > 0 && n_columns > 0)
      zgetrs_(&kind,
              &n,
              &n_columns,
              factors.data(),
              &n,
              pivots.data(),
              right_hand_sides,
              &n,
              &info);
  }



  void
  ComplexLU::solve(ComplexMatrix &B) const
  {
    solve('N', B.n_columns(), B.data());
  }



  void
  ComplexLU::solve(ComplexVector &b) const
  {
    solve('N', 1, b.data());
  }



  void
  ComplexLU::solve_adjoint(ComplexVector &b) const
  {
    solve('C', 1, b.data());
  }



  std::complex<double>
  ComplexLU::log_determinant() const
  {
    if (is_singular)
      return -std::numeric_limits<double>::infinity();
    double modulus = 0., phase = 0.;
    for (std::size_t i = 0; i < pivots.size(); ++i)
      {
        modulus += std::log(std::abs(factors(i, i)));
        phase += std::arg(factors(i, i));
        if (pivots[i] != static_cast<int>(i) + 1)
          phase += pi;
      }
    return {modulus, std::remainder(phase, 2 * pi)};
  }
} // namespace RollingContact
