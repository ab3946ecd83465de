#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/modes/fading_waves.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace RollingContact
{
  namespace
  {
    /// of the largest, squares of singular values that are no waves
    const double no_wave = 1e-8;

    /** Least-squares solution of M X = B, with columns of M of like size. */
    ComplexMatrix least_squares(const ComplexMatrix &M, const ComplexMatrix &B)
    {
      ComplexMatrix   X = M.adjoint() * B;
      const ComplexLU normal(M.adjoint() * M);
      normal.solve(X);
      return X;
    }

    /** The block Hankel matrix of so many periods in a column. */
    ComplexMatrix hankel(const ComplexMatrix &samples, const Eigen::Index rows)
    {
      const Eigen::Index n       = samples.rows(),
                         columns = samples.cols() - rows + 1;
      ComplexMatrix result(n * rows, columns);
      for (Eigen::Index row = 0; row < rows; ++row)
        result.middleRows(row * n, n) = samples.middleCols(row, columns);
      return result;
    }

    /** The largest left singular vectors. */
    ComplexMatrix signals_in(const ComplexMatrix &H, const Eigen::Index most)
    {
      const Eigenpairs pairs = eigenpairs(ComplexMatrix(H * H.adjoint()));
      std::vector<std::size_t> order(pairs.values.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return pairs.values[a].real() > pairs.values[b].real();
      });
      Eigen::Index n = 0;
      while (n < most && pairs.values[order[n]].real() >
                           no_wave * pairs.values[order[0]].real())
        ++n;
      ComplexMatrix result(H.rows(), n);
      for (Eigen::Index j = 0; j < n; ++j)
        result.col(j) = pairs.vectors.col(order[j]);
      return result;
    }
  } // namespace

  FadingWaves::FadingWaves(const ComplexMatrix &samples,
                           const unsigned int   most)
  {
    const Eigen::Index n = samples.rows(), periods = samples.cols(),
                       rows = (periods + 1) / 2, columns = periods - rows + 1;
    const ComplexMatrix U =
      signals_in(hankel(samples, rows),
                 std::min<Eigen::Index>({most, n * (rows - 1), columns - 1}));
    const Eigen::Index  shorter = U.rows() - n;
    const ComplexValues z =
      eigenpairs(least_squares(U.topRows(shorter), U.bottomRows(shorter)))
        .values;
    factors = ComplexVector::Map(z.data(), z.size());
    ComplexMatrix powers(periods, factors.size());
    for (Eigen::Index row = 0; row < periods; ++row)
      powers.row(row) = factors.array().pow(row).matrix().transpose();
    amplitudes = least_squares(powers, samples.transpose()).transpose();
    left_over =
      (samples - amplitudes * powers.transpose()).norm() / samples.norm();
    ComplexVector last = powers.bottomRows(1).transpose();
    for (Eigen::Index j = 0; j < factors.size(); ++j)
      if (std::abs(factors[j]) < 1.)
        last[j] = 0.;
    reflected = (amplitudes * last).norm() / std::sqrt(double(n));
  }

  std::complex<double> FadingWaves::at(const Eigen::Index place,
                                       const double       periods) const
  {
    std::complex<double> sum = 0.;
    for (Eigen::Index j = 0; j < factors.size(); ++j)
      if (std::abs(factors[j]) < 1.)
        sum += amplitudes(place, j) * std::pow(factors[j], periods);
    return sum;
  }
} // namespace RollingContact
