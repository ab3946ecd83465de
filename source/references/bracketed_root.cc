#include <boost/math/tools/toms748_solve.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/references/bracketed_root.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace RollingContact::References
{
  double bracketed_root(const std::function<double(double)> &function,
                        const double                         lower,
                        const double                         upper)
  {
    const auto is_narrow = [](const double left, const double right) {
      const double scale = std::max({1., std::abs(left), std::abs(right)});
      return right - left <= 4 * std::numeric_limits<double>::epsilon() * scale;
    };
    constexpr std::uintmax_t max_evaluations = 200;
    std::uintmax_t           n_evaluations   = max_evaluations;
    const auto               bracket = boost::math::tools::toms748_solve(
      function, lower, upper, is_narrow, n_evaluations);
    if (n_evaluations >= max_evaluations)
      throw ConvergenceError(
        "Bracketed root: 200 evaluations were not enough.");
    return (bracket.first + bracket.second) / 2;
  }
} // namespace RollingContact::References
