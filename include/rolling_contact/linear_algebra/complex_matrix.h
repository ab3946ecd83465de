#ifndef rolling_contact_linear_algebra_complex_matrix_h
#define rolling_contact_linear_algebra_complex_matrix_h

#include <rolling_contact/linear_algebra/dense_matrix.h>

#include <complex>
#include <vector>

namespace RollingContact
{
  using ComplexVector = std::vector<std::complex<double>>;

  /**
   * A dense complex matrix stored by columns, as LAPACK wants it.
   */
  class ComplexMatrix
  {
  public:
    ComplexMatrix() = default;

    /**
     * Zero everywhere.
     */
    ComplexMatrix(const std::size_t n_rows, const std::size_t n_columns)
      : rows(n_rows)
      , columns(n_columns)
      , values(n_rows * n_columns, 0.)
    {}

    /**
     * A + s B of two real matrices of the same size.
     */
    ComplexMatrix(const DenseMatrix         &A,
                  const std::complex<double> s,
                  const DenseMatrix         &B);

    explicit ComplexMatrix(const DenseMatrix &A);

    std::size_t
    n_rows() const
    {
      return rows;
    }

    std::size_t
    n_columns() const
    {
      return columns;
    }

    std::complex<double> &
    operator()(const std::size_t i, const std::size_t j)
    {
      return values[i + j * rows];
    }

    std::complex<double>
    operator()(const std::size_t i, const std::size_t j) const
    {
      return values[i + j * rows];
    }

    std::complex<double> *
    data()
    {
      return values.data();
    }

    const std::complex<double> *
    data() const
    {
      return values.data();
    }

  private:
    std::size_t   rows    = 0;
    std::size_t   columns = 0;
    ComplexVector values;
  };

  ComplexMatrix
  operator*(const ComplexMatrix &A, const ComplexMatrix &B);

  ComplexVector
  operator*(const ComplexMatrix &A, const ComplexVector &x);

  ComplexVector
  operator*(const DenseMatrix &A, const ComplexVector &x);

  /**
   * A^T x, without conjugation.
   */
  ComplexVector
  transposed_product(const DenseMatrix &A, const ComplexVector &x);

  /**
   * x += factor y.
   */
  void
  add(ComplexVector             &x,
      const std::complex<double> factor,
      const ComplexVector       &y);

  double
  norm(const ComplexVector &x);

  /**
   * x^H y.
   */
  std::complex<double>
  dot(const ComplexVector &x, const ComplexVector &y);

  /**
   * The LU factors of a square complex matrix (zgetrf): solutions of systems,
   * its adjoint ones, and its determinant.
   */
  class ComplexLU
  {
  public:
    explicit ComplexLU(ComplexMatrix M);

    /**
     * True if a pivot is zero or no number: nothing can be solved then.
     */
    bool
    singular() const
    {
      return is_singular;
    }

    /**
     * Solve M X = B in place.
     */
    void
    solve(ComplexMatrix &B) const;

    void
    solve(ComplexVector &b) const;

    /**
     * Solve M^H x = b in place.
     */
    void
    solve_adjoint(ComplexVector &b) const;

    /**
     * ln det M, its imaginary part in (-pi, pi]; minus infinity if singular.
     */
    std::complex<double>
    log_determinant() const;

  private:
    void
    solve(const char                  kind,
          const int                   n_columns,
          std::complex<double> *const right_hand_sides) const;

    ComplexMatrix    factors;
    std::vector<int> pivots;
    bool             is_singular = false;
  };
} // namespace RollingContact

#endif
