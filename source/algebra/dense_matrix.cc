#include <rolling_contact/algebra/dense_matrix.h>

#include <cmath>
#include <numeric>

namespace RollingContact
{
  DenseMatrix columns_of(const std::vector<std::vector<double>> &vectors,
                         const std::size_t                       n_rows)
  {
    DenseMatrix result(n_rows, vectors.size());
    for (std::size_t j = 0; j < vectors.size(); ++j)
      result.col(j) = as_vector(vectors[j]);
    return result;
  }

  std::vector<double> operator*(const DenseMatrix         &M,
                                const std::vector<double> &x)
  {
    return block_product(M, 0, 0, M.rows(), x);
  }

  std::vector<double> block_product(const DenseMatrix         &M,
                                    const std::size_t          first_row,
                                    const std::size_t          first_column,
                                    const std::size_t          n_rows,
                                    const std::vector<double> &x)
  {
    std::vector<double> result(n_rows, 0.);
    as_vector(result).noalias() +=
      M.block(first_row, first_column, n_rows, x.size()) * as_vector(x);
    return result;
  }

  double dot(const std::vector<double> &x, const std::vector<double> &y)
  {
    return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
  }

  double norm(const std::vector<double> &x)
  {
    return std::sqrt(dot(x, x));
  }

  std::vector<double>
  sum(std::vector<double> x, const double factor, const std::vector<double> &y)
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += factor * y[i];
    return x;
  }
} // namespace RollingContact
