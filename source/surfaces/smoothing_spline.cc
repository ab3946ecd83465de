#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/surfaces/smoothing_spline.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace RollingContact::Profiles
{
  SmoothingSpline::SmoothingSpline(const std::vector<double> &x,
                                   const std::vector<double> &data,
                                   const double               length)
    : values(data)
    , slopes(x.size())
  {
    const std::size_t n      = x.size();
    const double      lambda = std::pow(length / (2 * M_PI), 4);
    const auto step = [&](const std::size_t i) { return x[i + 1] - x[i]; };
    // a column of Q: the second difference at point j + 1
    const auto second_difference = [&](const std::size_t j) {
      return std::array<double, 3>{
        {1 / step(j), -1 / step(j) - 1 / step(j + 1), 1 / step(j + 1)}};
    };
    const auto weight = [&](const std::size_t i) {
      return i == 0       ? step(0) / 2
             : i + 1 == n ? step(n - 2) / 2
                          : (step(i - 1) + step(i)) / 2;
    };

    // (R + lambda Q^T W^-1 Q) gamma = Q^T v, gamma the second derivatives
    DenseMatrix     matrix = DenseMatrix::Zero(3, n - 2); // diagonals
    Eigen::VectorXd inner  = Eigen::VectorXd::Zero(n - 2);
    for (std::size_t j = 0; j + 2 < n; ++j)
      {
        const auto q = second_difference(j);
        matrix(0, j) = (step(j) + step(j + 1)) / 3;
        if (j + 3 < n)
          matrix(1, j) = step(j + 1) / 6;
        for (std::size_t k = 0; k < 3; ++k)
          inner[j] += q[k] * data[j + k];
        for (std::size_t l = j; l < j + 3 && l + 2 < n; ++l)
          {
            const auto other = second_difference(l);
            for (std::size_t k = l - j; k < 3; ++k)
              matrix(l - j, j) +=
                lambda * q[k] * other[k - (l - j)] / weight(j + k);
          }
      }
    if (!solve_positive_definite_band(matrix, inner))
      throw std::runtime_error("smoothing spline: matrix not positive");
    std::vector<double> gamma(n, 0.);
    for (std::size_t j = 0; j + 2 < n; ++j)
      {
        const auto q = second_difference(j);
        gamma[j + 1] = inner[j];
        for (std::size_t k = 0; k < 3; ++k)
          values[j + k] -= lambda * q[k] * inner[j] / weight(j + k);
      }
    for (std::size_t i = 0; i + 1 < n; ++i)
      slopes[i] = (values[i + 1] - values[i]) / step(i) -
                  step(i) * (2 * gamma[i] + gamma[i + 1]) / 6;
    slopes[n - 1] = (values[n - 1] - values[n - 2]) / step(n - 2) +
                    step(n - 2) * (gamma[n - 2] + 2 * gamma[n - 1]) / 6;
  }
} // namespace RollingContact::Profiles
