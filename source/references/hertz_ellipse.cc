#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/hertz_ellipse.h>

#include <cmath>

namespace RollingContact::References
{
  namespace
  {

    /**
     * b/a from B/A = RD(0, 1, (b/a)^2)/RD(0, (b/a)^2, 1), which falls from
     * infinity to zero; |log(b/a)| < |log(B/A)|.
     */
    double axis_ratio(const double curvature_ratio)
    {
      const double log_curvature_ratio = std::log(curvature_ratio);
      const auto   residual            = [&](const double log_axis_ratio) {
        const double square = std::exp(2 * log_axis_ratio);
        return std::log(boost::math::ellint_rd(0., square, 1.) /
                        boost::math::ellint_rd(0., 1., square)) +
               log_curvature_ratio;
      };
      const double reach = 1 + std::abs(log_curvature_ratio);
      return std::exp(bracketed_root(residual, -reach, reach));
    }
  } // namespace

  double HertzEllipse::pressure(const double x, const double y) const
  {
    const double distance = std::hypot(x / half_width_x, y / half_width_y);
    if (!(distance < 1))
      return 0;
    return max_pressure * std::sqrt((1 - distance) * (1 + distance));
  }

  double HertzEllipse::load() const
  {
    return 2 * pi / 3 * half_width_x * half_width_y * max_pressure;
  }

  HertzEllipse hertz_ellipse(const double load,
                             const double curvature_x,
                             const double curvature_y,
                             const double contact_modulus)
  {
    check_not_negative("Load", load, "N");
    check_positive("Curvature of the gap along x", curvature_x, "1/m");
    check_positive("Curvature of the gap along y", curvature_y, "1/m");
    check_positive("Contact modulus", contact_modulus, "Pa");
    if (load == 0)
      return {0, 0, 0, 0};
    const double ratio        = axis_ratio(curvature_y / curvature_x);
    const double length       = load / (2 * pi * contact_modulus);
    const double half_width_x = std::cbrt(
      length / curvature_x * boost::math::ellint_rd(0., ratio * ratio, 1.));
    const double half_width_y = ratio * half_width_x;
    return {half_width_x,
            half_width_y,
            3 * load / (2 * pi * half_width_x * half_width_y),
            3 * length / half_width_x *
              boost::math::ellint_rf(0., ratio * ratio, 1.)};
  }

  double load_of_hertz_ellipse(const double approach,
                               const double curvature_x,
                               const double curvature_y,
                               const double contact_modulus)
  {
    check_finite("Approach", approach, "m");
    if (approach <= 0)
      return 0;
    // approach grows as load^(2/3)
    const HertzEllipse unit =
      hertz_ellipse(1, curvature_x, curvature_y, contact_modulus);
    return std::pow(approach / unit.approach, 1.5);
  }
} // namespace RollingContact::References
