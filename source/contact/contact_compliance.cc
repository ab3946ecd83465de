#include <rolling_contact/contact/contact_compliance.h>

namespace RollingContact
{
  std::vector<double>
  ContactCompliance::product(const std::size_t          first_row,
                             const std::size_t          first_column,
                             const std::size_t          n_rows,
                             const std::vector<double> &x) const
  {
    if (!grid)
      return block_product(matrix, first_row, first_column, n_rows, x);
    const std::size_t N = grid->n_nodes();
    return grid->product(x,
                         first_column / N,
                         first_row / N,
                         (first_row + n_rows) / N);
  }

  Eigen::VectorXd ContactCompliance::column(const std::size_t first_row,
                                            const std::size_t n_rows,
                                            const std::size_t j) const
  {
    if (!grid)
      return matrix.col(j).segment(first_row, n_rows);
    Eigen::VectorXd entries(n_rows);
    for (std::size_t i = 0; i < n_rows; ++i)
      entries[i] = (*grid)(first_row + i, j);
    return entries;
  }

  DenseMatrix &ContactCompliance::make_dense()
  {
    if (grid)
      matrix = grid->dense();
    grid.reset();
    return matrix;
  }
} // namespace RollingContact
