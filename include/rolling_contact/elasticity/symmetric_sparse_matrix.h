#ifndef rolling_contact_elasticity_symmetric_sparse_matrix_h
#define rolling_contact_elasticity_symmetric_sparse_matrix_h

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

    std::size_t
    size() const
    {
      return column_starts.empty() ? 0 : column_starts.size() - 1;
    }
  };
} // namespace RollingContact

#endif
