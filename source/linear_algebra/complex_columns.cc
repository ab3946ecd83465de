#include <rolling_contact/linear_algebra/complex_columns.h>

namespace RollingContact
{
  ComplexVector
  ComplexColumns::vector(const std::size_t k) const
  {
    ComplexVector x(n_rows());
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = {columns(i, 2 * k), columns(i, 2 * k + 1)};
    return x;
  }



  void
  ComplexColumns::set(const std::size_t k, const ComplexVector &x)
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        columns(i, 2 * k)     = x[i].real();
        columns(i, 2 * k + 1) = x[i].imag();
      }
  }



  void
  ComplexColumns::add(const std::complex<double> factor,
                      const ComplexColumns      &x,
                      const std::size_t          k)
  {
    const double a = factor.real(), b = factor.imag();
    for (std::size_t i = 0; i < n_rows(); ++i)
      {
        const double real      = x.columns(i, 2 * k),
                     imaginary = x.columns(i, 2 * k + 1);
        columns(i, 2 * k) += a * real - b * imaginary;
        columns(i, 2 * k + 1) += a * imaginary + b * real;
      }
  }



  void
  ComplexColumns::add(const ComplexColumns &x)
  {
    for (std::size_t k = 0; k < n_vectors(); ++k)
      add(1., x, k);
  }



  void
  ComplexColumns::scale_rows(const std::vector<double> &factors)
  {
    for (std::size_t j = 0; j < columns.n_columns(); ++j)
      for (std::size_t i = 0; i < factors.size(); ++i)
        columns(i, j) *= factors[i];
  }



  ComplexColumns
  operator*(const DenseMatrix &A, const ComplexColumns &X)
  {
    return ComplexColumns(dense_product(A, X.real_columns()));
  }



  ComplexColumns
  transposed_product(const DenseMatrix &A, const ComplexColumns &X)
  {
    return ComplexColumns(transposed_product(A, X.real_columns()));
  }
} // namespace RollingContact
