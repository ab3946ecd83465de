#include <rolling_contact/linear_algebra/blas.h>
#include <rolling_contact/profiles/smoothing_spline.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace RollingContact::Profiles
{
  namespace
  {
    const int bandwidth = 2;

    /**
     * A symmetric matrix with two diagonals above the main one, as LAPACK takes
     * its lower half.
     */
    class BandMatrix
    {
    public:
      explicit BandMatrix(const std::size_t n)
        : entries((bandwidth + 1) * n, 0.)
      {}

      double &
      operator()(const std::size_t row, const std::size_t column)
      {
        return entries[(row - column) + (bandwidth + 1) * column];
      }

      /** The solution for a right-hand side. */
      std::vector<double>
      solve(std::vector<double> right_hand_side)
      {
        const int n = right_hand_side.size(), one = 1, leading = bandwidth + 1;
        int       info = 0;
        dpbsv_("L",
               &n,
               &bandwidth,
               &one,
               entries.data(),
               &leading,
               right_hand_side.data(),
               &n,
               &info);
        if (info != 0)
          throw std::runtime_error("smoothing spline: matrix not positive");
        return right_hand_side;
      }

    private:
      std::vector<double> entries;
    };
  } // namespace



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
    BandMatrix          matrix(n - 2);
    std::vector<double> right_hand_side(n - 2);
    for (std::size_t j = 0; j + 2 < n; ++j)
      {
        const auto q = second_difference(j);
        matrix(j, j) = (step(j) + step(j + 1)) / 3;
        if (j + 3 < n)
          matrix(j + 1, j) = step(j + 1) / 6;
        for (std::size_t k = 0; k < 3; ++k)
          right_hand_side[j] += q[k] * data[j + k];
        for (std::size_t l = j; l < j + 3 && l + 2 < n; ++l)
          {
            const auto other = second_difference(l);
            for (std::size_t k = l - j; k < 3; ++k)
              matrix(l, j) +=
                lambda * q[k] * other[k - (l - j)] / weight(j + k);
          }
      }
    const std::vector<double> inner = matrix.solve(right_hand_side);
    std::vector<double>       gamma(n, 0.);
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
