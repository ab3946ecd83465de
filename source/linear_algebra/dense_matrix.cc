#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/linear_algebra/dense_matrix.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace RollingContact
{
  DenseMatrix::DenseMatrix(const std::size_t n_rows,
                           const std::size_t n_columns)
    : rows(n_rows)
    , columns(n_columns)
    , values(n_rows * n_columns, 0.)
  {}



  void
  DenseMatrix::mirror_lower_triangle()
  {
    for (std::size_t j = 0; j < columns; ++j)
      for (std::size_t i = 0; i < j; ++i)
        (*this)(i, j) = (*this)(j, i);
  }



  void
  DenseMatrix::multiply_block(const std::size_t          first_row,
                              const std::size_t          first_column,
                              const std::vector<double> &x,
                              std::vector<double>       &result) const
  {
    const int    m = result.size(), n = x.size(), lda = rows, one = 1;
    const double alpha = 1., beta = 0.;
    if (m > 0 && n > 0)
      dgemv_("N",
             &m,
             &n,
             &alpha,
             &values[first_row + first_column * rows],
             &lda,
             x.data(),
             &one,
             &beta,
             result.data(),
             &one);
  }



  bool
  solve_positive_definite(DenseMatrix &M, DenseMatrix &right_hand_sides)
  {
    const int n = M.n_rows(), n_rhs = right_hand_sides.n_columns();
    int       info = 0;
    if (n > 0)
      dposv_("L", &n, &n_rhs, M.data(), &n, right_hand_sides.data(), &n, &info);
    return info == 0;
  }



  bool
  solve_general(DenseMatrix &M, DenseMatrix &right_hand_sides)
  {
    const int        n = M.n_rows(), n_rhs = right_hand_sides.n_columns();
    int              info = 0;
    std::vector<int> pivots(n);
    if (n > 0)
      dgesv_(&n,
             &n_rhs,
             M.data(),
             &n,
             pivots.data(),
             right_hand_sides.data(),
             &n,
             &info);
    return info == 0;
  }



  bool
  solve_least_squares(DenseMatrix &M, std::vector<double> &right_hand_side)
  {
    const int m = M.n_rows(), n = M.n_columns(), one = 1, n_work = 64 * (m + n);
    int       info = 0;
    std::vector<double> work(n_work);
    dgels_("N",
           &m,
           &n,
           &one,
           M.data(),
           &m,
           right_hand_side.data(),
           &m,
           work.data(),
           &n_work,
           &info);
    right_hand_side.resize(n);
    return info == 0;
  }



  double
  largest_eigenvalue(DenseMatrix &M, std::vector<double> &vector)
  {
    const int           n = M.n_rows(), n_work = 33 * n, n_int_work = 10 * n;
    const double        unused = 0., tolerance = 0.;
    int                 n_found = 0, info = 0;
    std::vector<int>    support(2), int_work(n_int_work);
    std::vector<double> values(n), work(n_work);
    vector.assign(n, 0.);
    dsyevr_("V",
            "I",
            "L",
            &n,
            M.data(),
            &n,
            &unused,
            &unused,
            &n,
            &n,
            &tolerance,
            &n_found,
            values.data(),
            vector.data(),
            &n,
            support.data(),
            work.data(),
            &n_work,
            int_work.data(),
            &n_int_work,
            &info);
    if (info == 0 && n_found == 1)
      return values[0];
    vector.clear();
    return std::numeric_limits<double>::infinity();
  }



  void
  symmetric_eigenpairs(DenseMatrix &M, std::vector<double> &values)
  {
    const int n = M.n_rows();
    values.assign(n, 0.);
    if (n == 0)
      return;
    const int           n_work = 1 + 6 * n + 2 * n * n, n_int_work = 3 + 5 * n;
    int                 info = 0;
    std::vector<double> work(n_work);
    std::vector<int>    int_work(n_int_work);
    dsyevd_("V",
            "L",
            &n,
            M.data(),
            &n,
            values.data(),
            work.data(),
            &n_work,
            int_work.data(),
            &n_int_work,
            &info);
    if (info != 0)
      throw std::runtime_error("LAPACK found no eigenvalues of a matrix of " +
                               std::to_string(n) +
                               " rows (dsyevd: " + std::to_string(info) + ").");
  }



  double
  dot(const std::vector<double> &x, const std::vector<double> &y)
  {
    return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
  }



  double
  norm(const std::vector<double> &x)
  {
    return std::sqrt(dot(x, x));
  }
} // namespace RollingContact
