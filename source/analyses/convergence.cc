#include <rolling_contact/analyses/convergence.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  double observed_order(const double change_before, const double change_now)
  {
    if (change_now == 0.)
      return 3.;
    return std::clamp(std::log2(std::abs(change_before / change_now)), 1., 3.);
  }

  double extrapolated(const double coarse,
                      const double fine,
                      const double ratio,
                      const double order)
  {
    return fine + (fine - coarse) / (std::pow(ratio, order) - 1);
  }
} // namespace RollingContact
