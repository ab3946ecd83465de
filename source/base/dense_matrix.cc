#include <rolling_contact/base/blas.h>
#include <rolling_contact/base/dense_matrix.h>

#include <cmath>
#include <numeric>

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
