#ifndef rolling_contact_algebra_skew_sparse_matrix_h
#define rolling_contact_algebra_skew_sparse_matrix_h

#include <rolling_contact/algebra/symmetric_sparse_matrix.h>

#include <algorithm>
#include <vector>

namespace RollingContact
{
  /**
   * A sparse matrix with S^T = -S, by its lower triangle.
   */
  struct SkewSparseMatrix
  {
    SymmetricSparseMatrix lower;

    std::size_t size() const
    {
      return lower.size();
    }

    /**
     * Product result = S x, for @p result of the size of @p x.
     */
    void multiply(const std::vector<double> &x,
                  std::vector<double>       &result) const
    {
      std::fill(result.begin(), result.end(), 0.);
      for (std::size_t j = 0; j < size(); ++j)
        for (auto k = lower.column_starts[j]; k < lower.column_starts[j + 1];
             ++k)
          {
            const std::int64_t i = lower.row_indices[k];
            result[i] += lower.values[k] * x[j];
            result[j] -= lower.values[k] * x[i];
          }
    }
  };
} // namespace RollingContact

#endif
