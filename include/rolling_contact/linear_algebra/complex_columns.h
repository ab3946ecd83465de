#ifndef rolling_contact_linear_algebra_complex_columns_h
#define rolling_contact_linear_algebra_complex_columns_h

#include <rolling_contact/linear_algebra/block_products.h>
#include <rolling_contact/linear_algebra/complex_matrix.h>

#include <utility>

namespace RollingContact
{
  /**
   * Complex vectors, each as two real columns side by side, real and imaginary
   * part: real matrices multiply all of them in one pass.
   */
  class ComplexColumns
  {
  public:
    /** Zero everywhere. */
    ComplexColumns(const std::size_t n_rows, const std::size_t n_vectors)
      : columns(n_rows, 2 * n_vectors)
    {}

    explicit ComplexColumns(DenseMatrix columns)
      : columns(std::move(columns))
    {}

    std::size_t
    n_rows() const
    {
      return columns.n_rows();
    }

    std::size_t
    n_vectors() const
    {
      return columns.n_columns() / 2;
    }

    /** Real and imaginary parts in turn. */
    const DenseMatrix &
    real_columns() const
    {
      return columns;
    }

    DenseMatrix &
    real_columns()
    {
      return columns;
    }

    ComplexVector
    vector(const std::size_t k) const;

    void
    set(const std::size_t k, const ComplexVector &x);

    /** y_k += factor x_k of one of the vectors. */
    void
    add(const std::complex<double> factor,
        const ComplexColumns      &x,
        const std::size_t          k);

    /** y_k += x_k of all. */
    void
    add(const ComplexColumns &x);

    /** Each row by a factor of its own. */
    void
    scale_rows(const std::vector<double> &factors);

  private:
    DenseMatrix columns;
  };



  /** A X of a sparse matrix, which multiplies vectors. */
  template <class Matrix>
  ComplexColumns
  times(const Matrix &A, const ComplexColumns &X)
  {
    return ComplexColumns(times(A, X.real_columns()));
  }



  /** A X and A^T X by dgemm. */
  ComplexColumns
  operator*(const DenseMatrix &A, const ComplexColumns &X);

  ComplexColumns
  transposed_product(const DenseMatrix &A, const ComplexColumns &X);
} // namespace RollingContact

#endif
