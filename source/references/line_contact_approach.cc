#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/line_contact_approach.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace RollingContact::References
{
  namespace
  {
    /**
     * (1-nu^2) P/(pi E) times a factor of extent over half-width.
     */
    double compression(const std::string                   &quantity,
                       const double                         extent,
                       const double                         young_modulus,
                       const double                         poisson_ratio,
                       const HertzLine                     &contact,
                       const std::function<double(double)> &factor)
    {
      if (contact.half_width == 0)
        return 0;
      check_elasticity(young_modulus, poisson_ratio);
      check_positive(quantity, extent, "m");
      return (1 - poisson_ratio * poisson_ratio) * contact.load_per_length() /
             (pi * young_modulus) * factor(extent / contact.half_width);
    }
  } // namespace

  double compression_of_disc(const double     radius,
                             const double     young_modulus,
                             const double     poisson_ratio,
                             const HertzLine &contact)
  {
    return compression("Radius of the disc",
                       radius,
                       young_modulus,
                       poisson_ratio,
                       contact,
                       [](const double ratio) {
                         return 2 * std::log(4 * ratio) - 1;
                       });
  }

  double compression_of_layer(const double     depth,
                              const double     young_modulus,
                              const double     poisson_ratio,
                              const HertzLine &contact)
  {
    return compression("Depth of the layer",
                       depth,
                       young_modulus,
                       poisson_ratio,
                       contact,
                       [&](const double ratio) {
                         // t (sqrt(1+t^2) - t), without cancellation
                         const double lateral =
                           ratio / (std::hypot(1, ratio) + ratio);
                         return 2 *
                                (std::asinh(ratio) -
                                 poisson_ratio / (1 - poisson_ratio) * lateral);
                       });
  }

  double half_width_of_approach(
    const std::function<double(double)> &approach_of_half_width,
    const double                         largest_half_width,
    const double                         approach)
  {
    check_finite("Approach", approach, "m");
    if (approach <= 0)
      return 0;
    const double largest = approach_of_half_width(largest_half_width);
    if (!(approach < largest))
      {
        std::ostringstream allowed;
        allowed << "smaller than " << largest
                << " m, where the half-width reaches " << largest_half_width
                << " m";
        reject("Approach", approach, "m", allowed.str());
      }
    // from below, as the first half-width is meant where there are several
    const double step = 1.25;
    double lower = largest_half_width * std::min(1e-8, approach / largest / 2);
    while (approach_of_half_width(std::min(step * lower, largest_half_width)) <
           approach)
      lower *= step;
    const auto residual = [&](const double log_half_width) {
      return approach_of_half_width(std::exp(log_half_width)) / approach - 1;
    };
    const double upper = std::min(step * lower, largest_half_width);
    return std::exp(bracketed_root(residual, std::log(lower), std::log(upper)));
  }
} // namespace RollingContact::References
