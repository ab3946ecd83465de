#include <rolling_contact/algebra/symmetric_sparse_matrix.h>

#include <algorithm>
#include <numeric>

namespace RollingContact
{
  void SymmetricSparseMatrix::multiply(const std::vector<double> &x,
                                       std::vector<double>       &result) const
  {
    std::fill(result.begin(), result.end(), 0.);
    for (std::size_t j = 0; j < size(); ++j)
      {
        const std::int64_t diagonal = column_starts[j],
                           end      = column_starts[j + 1];
        const double x_j            = x[j];
        double       sum            = values[diagonal] * x_j;
        for (std::int64_t k = diagonal + 1; k < end; ++k)
          {
            sum += values[k] * x[row_indices[k]];
            result[row_indices[k]] += values[k] * x_j;
          }
        result[j] += sum;
      }
  }

  void SymmetricSparseMatrix::multiply(const std::vector<double> &x,
                                       std::vector<double>       &result,
                                       const std::vector<double> &y,
                                       std::vector<double> &result_of_y) const
  {
    std::fill(result.begin(), result.end(), 0.);
    std::fill(result_of_y.begin(), result_of_y.end(), 0.);
    for (std::size_t j = 0; j < size(); ++j)
      {
        const std::int64_t diagonal = column_starts[j],
                           end      = column_starts[j + 1];
        const double x_j = x[j], y_j = y[j];
        double sum = values[diagonal] * x_j, sum_y = values[diagonal] * y_j;
        for (std::int64_t k = diagonal + 1; k < end; ++k)
          {
            const std::int64_t i     = row_indices[k];
            const double       value = values[k];
            sum += value * x[i];
            sum_y += value * y[i];
            result[i] += value * x_j;
            result_of_y[i] += value * y_j;
          }
        result[j] += sum;
        result_of_y[j] += sum_y;
      }
  }

  SymmetricSparseMatrix diagonal_matrix(const std::vector<double> &entries)
  {
    SymmetricSparseMatrix result;
    result.values = entries;
    result.row_indices.resize(entries.size());
    std::iota(result.row_indices.begin(), result.row_indices.end(), 0);
    result.column_starts.resize(entries.size() + 1);
    std::iota(result.column_starts.begin(), result.column_starts.end(), 0);
    return result;
  }

  SymmetricSparseMatrix linear_combination(const double                 a,
                                           const SymmetricSparseMatrix &A,
                                           const double                 b,
                                           const SymmetricSparseMatrix &B)
  {
    SymmetricSparseMatrix sum;
    const std::size_t n_entries = std::max(A.values.size(), B.values.size());
    sum.row_indices.reserve(n_entries);
    sum.values.reserve(n_entries);
    sum.column_starts.reserve(A.size() + 1);
    sum.column_starts.push_back(0);
    for (std::size_t j = 0; j < A.size(); ++j)
      {
        std::int64_t       of_A = A.column_starts[j], of_B = B.column_starts[j];
        const std::int64_t end_A = A.column_starts[j + 1],
                           end_B = B.column_starts[j + 1];
        while (of_A < end_A || of_B < end_B)
          {
            const bool in_A =
              of_A < end_A &&
              (of_B == end_B || A.row_indices[of_A] <= B.row_indices[of_B]);
            const bool in_B =
              of_B < end_B &&
              (of_A == end_A || B.row_indices[of_B] <= A.row_indices[of_A]);
            sum.row_indices.push_back(in_A ? A.row_indices[of_A]
                                           : B.row_indices[of_B]);
            sum.values.push_back((in_A ? a * A.values[of_A++] : 0.) +
                                 (in_B ? b * B.values[of_B++] : 0.));
          }
        sum.column_starts.push_back(sum.values.size());
      }
    return sum;
  }
} // namespace RollingContact
