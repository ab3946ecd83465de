#include <rolling_contact/linear_algebra/dense_matrix.h>
#include <rolling_contact/linear_algebra/polynomial_fit.h>

#include <cmath>

namespace RollingContact
{
  std::vector<double>
  without_polynomial(const std::vector<double> &x,
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
    DenseMatrix         powers(end - first, degree + 1);
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
} // namespace RollingContact
