#include <rolling_contact/algebra/reflection.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace RollingContact
{
  namespace
  {
    double
    entry(const SymmetricSparseMatrix &A, std::size_t row, std::size_t column)
    {
      if (row < column)
        std::swap(row, column);
      const auto begin = A.row_indices.begin() + A.column_starts[column],
                 end   = A.row_indices.begin() + A.column_starts[column + 1];
      const auto found =
        std::lower_bound(begin, end, static_cast<std::int64_t>(row));
      return found == end || *found != static_cast<std::int64_t>(row)
               ? 0.
               : A.values[found - A.row_indices.begin()];
    }

    /** Unknowns and their shares in a vector. */
    using Shares = std::vector<std::pair<std::size_t, double>>;

    /** What unknown i must share its motion with, by all products of the
     * reflections; empty if they forbid it to move. */
    Shares orbit(const std::vector<Reflection> &reflections,
                 const std::vector<int>        &parity,
                 const std::size_t              i)
    {
      Shares shares{{i, 1.}};
      for (std::size_t r = 0; r < reflections.size(); ++r)
        {
          const std::size_t n = shares.size();
          for (std::size_t k = 0; k < n; ++k)
            {
              const auto [j, share] = shares[k];
              shares.emplace_back(reflections[r].image[j],
                                  parity[r] * reflections[r].sign[j] * share);
            }
        }
      std::sort(shares.begin(), shares.end());
      Shares sums;
      for (const auto &[j, share] : shares)
        if (!sums.empty() && sums.back().first == j)
          sums.back().second += share;
        else
          sums.emplace_back(j, share);
      double square = 0.;
      for (const auto &sum : sums)
        square += sum.second * sum.second;
      if (square == 0.)
        return {};
      for (auto &sum : sums)
        sum.second /= std::sqrt(square);
      return sums;
    }

    /** Append the entries of one column, equal rows added. */
    void
    append_column(std::vector<std::pair<std::int64_t, double>>::iterator begin,
                  std::vector<std::pair<std::int64_t, double>>::iterator end,
                  SymmetricSparseMatrix                                 &A)
    {
      std::sort(begin, end);
      const auto first = static_cast<std::size_t>(A.column_starts.back());
      for (; begin != end; ++begin)
        if (A.values.size() > first && begin->first == A.row_indices.back())
          A.values.back() += begin->second;
        else
          {
            A.row_indices.push_back(begin->first);
            A.values.push_back(begin->second);
          }
      A.column_starts.push_back(A.values.size());
    }
  } // namespace

  double asymmetry(const SymmetricSparseMatrix &A, const Reflection &R)
  {
    double result = 0.;
    for (std::size_t j = 0; j < A.size(); ++j)
      for (std::int64_t k = A.column_starts[j]; k < A.column_starts[j + 1]; ++k)
        {
          const std::size_t i     = A.row_indices[k];
          const double      image = R.sign[i] * R.sign[j] *
                               entry(A, R.image[i], R.image[j]),
                       scale = A.values[A.column_starts[i]] *
                               A.values[A.column_starts[j]];
          if (image != A.values[k])
            result = std::max(result,
                              std::abs(image - A.values[k]) / std::sqrt(scale));
        }
    return result;
  }

  InvariantSubspace::InvariantSubspace(
    const std::vector<Reflection> &reflections,
    const std::vector<int>        &parity,
    const std::size_t              n_unknowns)
    : column(n_unknowns, 0)
    , weight(n_unknowns, 0.)
  {
    std::vector<bool> seen(n_unknowns, false);
    for (std::size_t i = 0; i < n_unknowns; ++i)
      {
        if (seen[i])
          continue;
        const Shares shares = orbit(reflections, parity, i);
        seen[i]             = true;
        for (const auto &[j, share] : shares)
          {
            seen[j]   = true;
            column[j] = first_unknown.size();
            weight[j] = share;
          }
        if (!shares.empty())
          first_unknown.push_back(i);
      }
  }

  SymmetricSparseMatrix
  InvariantSubspace::restricted(const SymmetricSparseMatrix &A) const
  {
    const auto each_entry = [&](const auto &visit) {
      for (std::size_t j = 0; j < A.size(); ++j)
        for (std::int64_t k = A.column_starts[j]; k < A.column_starts[j + 1];
             ++k)
          {
            const std::size_t i = A.row_indices[k];
            if (weight[i] == 0. || weight[j] == 0.)
              continue;
            const double value = weight[i] * A.values[k] * weight[j];
            // one triangle: both places of an entry may fall on the diagonal
            visit(std::max(column[i], column[j]),
                  std::min(column[i], column[j]),
                  i != j && column[i] == column[j] ? 2 * value : value);
          }
    };
    std::vector<std::size_t> ends(size() + 1, 0);
    each_entry(
      [&](std::size_t, const std::size_t low, double) { ++ends[low + 1]; });
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<std::pair<std::int64_t, double>> entries(ends.back());
    std::vector<std::size_t>                     at = ends;
    each_entry(
      [&](const std::size_t high, const std::size_t low, const double value) {
        entries[at[low]++] = {high, value};
      });
    SymmetricSparseMatrix result;
    result.column_starts.push_back(0);
    for (std::size_t j = 0; j < size(); ++j)
      append_column(entries.begin() + ends[j],
                    entries.begin() + ends[j + 1],
                    result);
    return result;
  }

  std::vector<unsigned int> InvariantSubspace::nodes_of_columns(
    const std::vector<unsigned int> &node_of_unknown) const
  {
    std::vector<unsigned int> result(size(), 0);
    for (std::size_t k = 1; k < size(); ++k)
      result[k] = result[k - 1] + (node_of_unknown[first_unknown[k]] !=
                                   node_of_unknown[first_unknown[k - 1]]);
    return result;
  }

  void InvariantSubspace::extend(const DenseMatrix &X,
                                 const std::size_t  k,
                                 DenseMatrix       &result,
                                 const std::size_t  at) const
  {
    for (std::size_t i = 0; i < weight.size(); ++i)
      result(i, at) = weight[i] == 0. ? 0. : weight[i] * X(column[i], k);
  }

  std::vector<InvariantSubspace>
  invariant_subspaces(const std::vector<Reflection> &reflections,
                      const std::size_t              n_unknowns)
  {
    std::vector<InvariantSubspace> result;
    for (unsigned int bits = 0; bits < (1u << reflections.size()); ++bits)
      {
        std::vector<int> parity;
        for (std::size_t r = 0; r < reflections.size(); ++r)
          parity.push_back((bits >> r) & 1u ? -1 : 1);
        InvariantSubspace space(reflections, parity, n_unknowns);
        if (space.size() > 0)
          result.push_back(std::move(space));
      }
    return result;
  }
} // namespace RollingContact
