#include <rolling_contact/damage/shakedown.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/line_contact_stress.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact::Damage
{
  namespace
  {
    using References::PlaneStresses;

    /** Below p0 = a = 1, and the traction mu_u p. */
    PlaneStresses line_stresses(const double x,
                                const double depth,
                                const double utilised_friction)
    {
      const PlaneStresses p = References::stresses_of_pressure(x, depth, 1, 1),
                          q = References::stresses_of_traction(
                            x, depth, 1, utilised_friction);
      return {p.xx + q.xx, p.zz + q.zz, p.xz + q.xz};
    }

    double tresca_shear(const PlaneStresses &stress, const double poisson_ratio)
    {
      const double radius = std::hypot((stress.xx - stress.zz) / 2, stress.xz),
                   middle = (stress.xx + stress.zz) / 2,
                   along  = 2 * poisson_ratio * middle;
      return std::max(radius, (radius + std::abs(middle - along)) / 2);
    }

    /**
     * The largest value on a grid of x and depth, which shrinks around it; x is
     * within 1.2 of the middle, depth within 1.2 of the surface.
     */
    template <class Shear>
    ShearPeak largest(const Shear &shear, const bool on_axis = false)
    {
      const int    n     = 20;
      double       reach = 1.2, x = 0., z = 0.6;
      ShearPeak    peak;
      const double shrinking = 0.3, smallest = 1e-6;
      for (; reach > smallest; reach *= shrinking)
        {
          const double middle_x = x, middle_z = z;
          for (int i = on_axis ? 0 : -n; i <= (on_axis ? 0 : n); ++i)
            for (int j = -n; j <= n; ++j)
              {
                const double at    = middle_x + reach * i / n,
                             depth = std::max(0., middle_z + reach / 2 * j / n),
                             value = shear(at, depth);
                if (value > peak.shear)
                  {
                    peak = {value, depth};
                    x    = at;
                    z    = depth;
                  }
              }
        }
      return peak;
    }
  } // namespace

  ShearPeak line_shear(const double utilised_friction,
                       const double poisson_ratio)
  {
    References::check_not_negative("Utilised friction", utilised_friction);
    References::check_elasticity(1., poisson_ratio);
    return largest([&](const double x, const double depth) {
      return tresca_shear(line_stresses(x, depth, utilised_friction),
                          poisson_ratio);
    });
  }

  ShearPeak line_orthogonal_shear(const double utilised_friction)
  {
    References::check_not_negative("Utilised friction", utilised_friction);
    return largest([&](const double x, const double depth) {
      return std::abs(line_stresses(x, depth, utilised_friction).xz);
    });
  }

  ShearPeak circle_shear(const double poisson_ratio)
  {
    References::check_elasticity(1., poisson_ratio);
    const auto shear = [&](double, const double z) {
      const double fall  = 1 / (1 + z * z),
                   angle = std::atan2(1., z); // atan(a/z)
      return std::abs(1.5 * fall - (1 + poisson_ratio) * (1 - z * angle)) / 2;
    };
    return largest(shear, true);
  }

  ShakedownLimits shakedown_limits(const double utilised_friction,
                                   const double poisson_ratio)
  {
    const double point_shakedown = 4.7; // without friction
    const double surface         = utilised_friction > 0.
                                     ? 1 / utilised_friction
                                     : std::numeric_limits<double>::infinity();
    return {utilised_friction,
            1 / line_shear(utilised_friction, poisson_ratio).shear,
            1 / line_orthogonal_shear(utilised_friction).shear,
            std::min(surface, 1 / circle_shear(poisson_ratio).shear),
            std::min(surface, point_shakedown),
            surface};
  }

  std::vector<ShakedownLimits>
  shakedown_map(const double       most_utilised_friction,
                const unsigned int n_steps,
                const double       poisson_ratio)
  {
    References::check_positive("Most utilised friction",
                               most_utilised_friction);
    if (n_steps == 0)
      References::reject("Number of steps", 0, "", "at least 1");
    std::vector<ShakedownLimits> map;
    for (unsigned int k = 0; k <= n_steps; ++k)
      map.push_back(
        shakedown_limits(most_utilised_friction * k / n_steps, poisson_ratio));
    return map;
  }
} // namespace RollingContact::Damage
