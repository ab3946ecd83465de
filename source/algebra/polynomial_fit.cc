#include <rolling_contact/algebra/lapack.h>
#include <rolling_contact/algebra/polynomial_fit.h>

#include <cmath>

namespace RollingContact
{
  std::vector<double> without_polynomial(const std::vector<double> &x,
                                         std::vector<double>        values,
                                         const std::size_t          first,
                                         const std::size_t          end,
                                         const unsigned int         degree)
  {
    if (end < first + degree + 1)
      return values;
    // powers of a place that runs from -1 to 1 over those fitted
    const auto power = [&](const std::size_t k, const unsigned int exponent) {
      return std::pow(2 * (x[k] - x[first]) / (x[end - 1] - x[first]) - 1,
                      exponent);
    };
    DenseMatrix         powers = DenseMatrix::Zero(end - first, degree + 1);
    std::vector<double> coefficients(values.begin() + first,
                                     values.begin() + end);
    for (std::size_t k = first; k < end; ++k)
      for (unsigned int d = 0; d <= degree; ++d)
        powers(k - first, d) = power(k, d);
    if (!solve_least_squares(powers, coefficients))
      return values;
    for (std::size_t k = 0; k < values.size(); ++k)
      for (unsigned int d = 0; d <= degree; ++d)
        values[k] -= coefficients[d] * power(k, d);
    return values;
  }

  std::vector<double> derivative_weights(const std::vector<double> &x)
  {
    // d/dx of the product of (0 - x_m) / (x_j - x_m) over all m but j
    std::vector<double> weights(x.size(), 0.);
    for (std::size_t j = 0; j < x.size(); ++j)
      for (std::size_t left = 0; left < x.size(); ++left)
        {
          if (left == j)
            continue;
          double term = 1.;
          for (std::size_t m = 0; m < x.size(); ++m)
            if (m != j)
              term *= (m == left ? 1. : -x[m]) / (x[j] - x[m]);
          weights[j] += term;
        }
    return weights;
  }
} // namespace RollingContact
