#include <rolling_contact/references/line_contact_stress.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    /**
     * m and n of McEwen: (m + i n)^2 = a^2 - x^2 + z^2 + 2 i x z, n with the
     * sign of x.
     */
    struct Roots
    {
      double m, n, sum;

      Roots(const double x, const double z, const double a)
      {
        const double real = a * a - x * x + z * z,
                     size = std::hypot(real, 2 * x * z);
        m                 = std::sqrt(std::max(0., size + real) / 2);
        n   = std::copysign(std::sqrt(std::max(0., size - real) / 2), x);
        sum = std::max(m * m + n * n, 1e-30 * a * a);
      }
    };
  } // namespace

  PlaneStresses stresses_of_pressure(const double x,
                                     const double depth,
                                     const double half_width,
                                     const double peak)
  {
    const Roots  roots(x, depth, half_width);
    const double share = (depth * depth + roots.n * roots.n) / roots.sum,
                 scale = -peak / half_width;
    return {scale * (roots.m * (1 + share) - 2 * depth),
            scale * roots.m * (1 - share),
            -scale * roots.n * (roots.m * roots.m - depth * depth) / roots.sum};
  }

  PlaneStresses stresses_of_traction(const double x,
                                     const double depth,
                                     const double half_width,
                                     const double peak)
  {
    const Roots         roots(x, depth, half_width);
    const PlaneStresses of_pressure =
      stresses_of_pressure(x, depth, half_width, peak);
    return {peak / half_width *
              (roots.n * (2 - (depth * depth - roots.m * roots.m) / roots.sum) -
               2 * x),
            -of_pressure.xz,
            -of_pressure.xx};
  }
} // namespace RollingContact::References
