#ifndef rolling_contact_algebra_symmetric_sparse_matrix_h
#define rolling_contact_algebra_symmetric_sparse_matrix_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace RollingContact
{
  /**
   * Lower triangle of a sparse symmetric matrix by compressed columns, row
   * indices ascending in each column, diagonal entries present.
   */
  struct SymmetricSparseMatrix
  {
    std::vector<std::int64_t> column_starts;
    std::vector<std::int64_t> row_indices;
    std::vector<double>       values;

    std::size_t size() const
    {
      return column_starts.empty() ? 0 : column_starts.size() - 1;
    }

    /**
     * Product result = S x, for @p result of the size of @p x.
     */
    void multiply(const std::vector<double> &x,
                  std::vector<double>       &result) const;

    /**
     * Products with two vectors, reading the matrix once.
     */
    void multiply(const std::vector<double> &x,
                  std::vector<double>       &result,
                  const std::vector<double> &y,
                  std::vector<double>       &result_of_y) const;

    std::size_t memory_consumption() const
    {
      return (column_starts.capacity() + row_indices.capacity()) *
               sizeof(std::int64_t) +
             values.capacity() * sizeof(double);
    }
  };

  SymmetricSparseMatrix diagonal_matrix(const std::vector<double> &entries);

  /**
   * Sum a A + b B on the union of both patterns, for matrices of the same size.
   */
  SymmetricSparseMatrix linear_combination(const double                 a,
                                           const SymmetricSparseMatrix &A,
                                           const double                 b,
                                           const SymmetricSparseMatrix &B);
} // namespace RollingContact

#endif
