#include <rolling_contact/algebra/sparse_rows.h>

namespace RollingContact
{
  void SparseRows::add(const unsigned int i,
                       const unsigned int j,
                       const double       value)
  {
    for (auto &entry : rows[i])
      if (entry.first == j)
        {
          entry.second += value;
          return;
        }
    rows[i].emplace_back(j, value);
  }

  double apply(const SparseRows::Row     &row,
               const std::vector<double> &x,
               const std::size_t          offset)
  {
    double sum = 0.;
    for (const auto &entry : row)
      sum += entry.second * x[offset + entry.first];
    return sum;
  }

  std::vector<double> SparseRows::multiply(const std::vector<double> &x) const
  {
    std::vector<double> y(x.size());
    for (std::size_t offset = 0; offset < x.size(); offset += size())
      for (unsigned int i = 0; i < size(); ++i)
        y[offset + i] = apply(rows[i], x, offset);
    return y;
  }

  std::vector<double>
  SparseRows::multiply_transposed(const std::vector<double> &x) const
  {
    std::vector<double> y(x.size(), 0.);
    for (std::size_t offset = 0; offset < x.size(); offset += size())
      for (unsigned int i = 0; i < size(); ++i)
        for (const auto &entry : rows[i])
          y[offset + entry.first] += entry.second * x[offset + i];
    return y;
  }

  SparseRows SparseRows::transposed() const
  {
    SparseRows result(size());
    for (unsigned int i = 0; i < size(); ++i)
      for (const auto &entry : rows[i])
        result.rows[entry.first].emplace_back(i, entry.second);
    return result;
  }

  DenseMatrix SparseRows::dense() const
  {
    DenseMatrix result = DenseMatrix::Zero(size(), size());
    for (unsigned int i = 0; i < size(); ++i)
      for (const auto &entry : rows[i])
        result(i, entry.first) += entry.second;
    return result;
  }

  SparseRows of_components(const SparseRows               &P,
                           const std::vector<std::size_t> &numbers,
                           const std::size_t               n)
  {
    const std::size_t n_components = n > 0 ? numbers.size() / n : 0;
    SparseRows        result(n_components * P.size());
    for (std::size_t c = 0; c < n_components; ++c)
      for (unsigned int i = 0; i < P.size(); ++i)
        for (const auto &[j, value] : P[i])
          result.add(c * P.size() + i, numbers[c * n + j], value);
    return result;
  }
} // namespace RollingContact
