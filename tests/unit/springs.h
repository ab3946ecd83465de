#ifndef rolling_contact_tests_springs_h
#define rolling_contact_tests_springs_h

#include <rolling_contact/algebra/factorisation.h>
#include <rolling_contact/algebra/symmetric_sparse_matrix.h>
#include <rolling_contact/base/constants.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

/** Structures whose modes are known. */
namespace SpringStructures
{
  using namespace RollingContact;

  /** Masses m on a line, on a square or in a cube of n places a side, between
   * springs of k = 1: eigenvalues are sums of those of a line. */
  struct Springs
  {
    Springs(const unsigned int n,
            const unsigned int dimensions,
            const bool         held)
      : n(n)
      , dimensions(dimensions)
      , held(held)
    {
      const std::size_t size = std::lround(std::pow(n, dimensions));
      K.column_starts.push_back(0);
      for (std::size_t i = 0; i < size; ++i)
        {
          double                   sum    = 0.;
          std::size_t              stride = 1;
          std::vector<std::size_t> next;
          for (unsigned int d = 0; d < dimensions; ++d, stride *= n)
            {
              const std::size_t at = (i / stride) % n;
              sum += (held || at > 0 ? 1 : 0) + (held || at + 1 < n ? 1 : 0);
              if (at + 1 < n)
                next.push_back(i + stride);
            }
          K.row_indices.push_back(i);
          K.values.push_back(sum);
          for (const std::size_t j : next)
            {
              K.row_indices.push_back(j);
              K.values.push_back(-1.);
            }
          K.column_starts.push_back(K.values.size());
        }
      M = diagonal_matrix(std::vector<double>(size, mass));
      nodes.resize(size);
      std::iota(nodes.begin(), nodes.end(), 0);
    }

    std::vector<double> eigenvalues() const
    {
      std::vector<double> line, sums{0.};
      for (unsigned int i = 0; i < n; ++i)
        line.push_back(held ? 2 - 2 * std::cos(pi * (i + 1) / (n + 1))
                            : 2 - 2 * std::cos(pi * i / n));
      for (unsigned int d = 0; d < dimensions; ++d)
        {
          std::vector<double> larger;
          for (const double a : sums)
            for (const double b : line)
              larger.push_back(a + b);
          sums = larger;
        }
      for (double &value : sums)
        value /= mass;
      std::sort(sums.begin(), sums.end());
      return sums;
    }

    Factorisation factor(const double shift) const
    {
      Factorisation result(linear_combination(1., K, shift, M), nodes);
      result.factorise();
      return result;
    }

    unsigned int              n, dimensions;
    bool                      held;
    double                    mass = 0.5;
    SymmetricSparseMatrix     K, M;
    std::vector<unsigned int> nodes;
  };

  inline double frequency(const double eigenvalue)
  {
    return std::sqrt(eigenvalue) / (2 * pi);
  }

  /** Between two different eigenvalues, from number k on. */
  inline double gap_after(const std::vector<double> &values, std::size_t k)
  {
    while (values[k + 1] - values[k] < 1e-6)
      ++k;
    return (values[k] + values[k + 1]) / 2;
  }
} // namespace SpringStructures

#endif
