#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/kalker.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace RollingContact::References
{
  namespace
  {

    /**
     * C11, C22, C23 and C33, each at nu = 0, 1/4, 1/2.
     */
    using Row = std::array<std::array<double, 3>, 4>;

    /**
     * Rows at 0.1, 0.2, ... 1.
     */
    using Table = std::array<Row, 10>;

    // clang-format off
    /**
     * Kalker 1990, table E3, by a/b (a <= b).
     */
    constexpr Table short_patch =
      {{
        {{{2.51, 3.31, 4.85}, {2.51, 2.52, 2.53}, {0.334, 0.473, 0.731}, {6.42, 8.28, 11.7}}},
        {{{2.59, 3.37, 4.81}, {2.59, 2.63, 2.66}, {0.483, 0.603, 0.809}, {3.46, 4.27, 5.66}}},
        {{{2.68, 3.44, 4.8}, {2.68, 2.75, 2.81}, {0.607, 0.715, 0.889}, {2.49, 2.96, 3.72}}},
        {{{2.78, 3.53, 4.82}, {2.78, 2.88, 2.98}, {0.72, 0.823, 0.977}, {2.02, 2.32, 2.77}}},
        {{{2.88, 3.62, 4.83}, {2.88, 3.01, 3.14}, {0.827, 0.929, 1.07}, {1.74, 1.93, 2.22}}},
        {{{2.98, 3.72, 4.91}, {2.98, 3.14, 3.31}, {0.93, 1.03, 1.18}, {1.56, 1.68, 1.86}}},
        {{{3.09, 3.81, 4.97}, {3.09, 3.28, 3.48}, {1.03, 1.14, 1.29}, {1.43, 1.5, 1.6}}},
        {{{3.19, 3.91, 5.05}, {3.19, 3.41, 3.65}, {1.13, 1.25, 1.4}, {1.34, 1.37, 1.42}}},
        {{{3.29, 4.01, 5.12}, {3.29, 3.54, 3.82}, {1.23, 1.36, 1.51}, {1.27, 1.27, 1.27}}},
        {{{3.4, 4.12, 5.2}, {3.4, 3.67, 3.98}, {1.33, 1.47, 1.63}, {1.21, 1.19, 1.16}}}
      }};

    /**
     * Table E3 by b/a (a >= b).
     */
    constexpr Table long_patch =
      {{
        {{{10.7, 11.7, 12.9}, {10.7, 12.8, 16}, {12.2, 14.6, 18}, {0.795, 0.526, 0.228}}},
        {{{6.96, 7.78, 8.82}, {6.96, 8.14, 9.79}, {5.72, 6.63, 7.89}, {0.828, 0.601, 0.341}}},
        {{{5.57, 6.34, 7.34}, {5.57, 6.4, 7.51}, {3.79, 4.32, 5.01}, {0.868, 0.674, 0.446}}},
        {{{4.84, 5.57, 6.57}, {4.84, 5.48, 6.31}, {2.88, 3.24, 3.7}, {0.912, 0.747, 0.549}}},
        {{{4.37, 5.1, 6.11}, {4.37, 4.9, 5.56}, {2.35, 2.62, 2.96}, {0.958, 0.819, 0.65}}},
        {{{4.06, 4.78, 5.8}, {4.06, 4.5, 5.04}, {2.01, 2.23, 2.5}, {1.01, 0.892, 0.751}}},
        {{{3.82, 4.54, 5.58}, {3.82, 4.21, 4.67}, {1.76, 1.95, 2.18}, {1.05, 0.965, 0.852}}},
        {{{3.65, 4.36, 5.42}, {3.65, 3.99, 4.39}, {1.58, 1.75, 1.94}, {1.1, 1.04, 0.954}}},
        {{{3.51, 4.22, 5.3}, {3.51, 3.81, 4.16}, {1.44, 1.59, 1.77}, {1.16, 1.11, 1.06}}},
        {{{3.4, 4.12, 5.2}, {3.4, 3.67, 3.98}, {1.33, 1.47, 1.63}, {1.21, 1.19, 1.16}}}
      }};
    // clang-format on

    /**
     * 1/C is the parabola through its values at nu = 0, 1/4, 1/2.
     */
    double interpolate_in_poisson_ratio(const std::array<double, 3> &values,
                                        const double poisson_ratio)
    {
      const double first  = 8 * (poisson_ratio - 0.25) * (poisson_ratio - 0.5);
      const double middle = -16 * poisson_ratio * (poisson_ratio - 0.5);
      const double last   = 8 * poisson_ratio * (poisson_ratio - 0.25);
      return 1 / (first / values[0] + middle / values[1] + last / values[2]);
    }

    KalkerCoefficients interpolate(const Table &table,
                                   const double smaller_ratio,
                                   const double poisson_ratio)
    {
      const double position = 10 * smaller_ratio - 1;
      const auto   row      = static_cast<unsigned int>(
        std::clamp(std::floor(position), 0., table.size() - 2.));
      const double weight = position - row;

      std::array<double, 4> coefficients;
      for (unsigned int i = 0; i < coefficients.size(); ++i)
        {
          std::array<double, 3> values;
          for (unsigned int j = 0; j < values.size(); ++j)
            values[j] =
              (1 - weight) * table[row][i][j] + weight * table[row + 1][i][j];
          coefficients[i] = interpolate_in_poisson_ratio(values, poisson_ratio);
        }
      return {coefficients[0],
              coefficients[1],
              coefficients[2],
              coefficients[3]};
    }

    /**
     * a << b: every strip across the patch rolls as a line contact.
     */
    KalkerCoefficients short_patch_limit(const double ratio, const double nu)
    {
      const double log_term = std::log(16 / (ratio * ratio));
      return {pi * pi / 4 / (1 - nu),
              pi * pi / 4,
              pi * std::sqrt(ratio) / 3 / (1 - nu) *
                (1 + nu * (log_term / 2 + std::log(4.) - 5)),
              pi * pi / 16 / (1 - nu) / ratio};
    }

    /**
     * a >> b.
     */
    KalkerCoefficients long_patch_limit(const double ratio, const double nu)
    {
      const double log_term = std::log(16 / (ratio * ratio));
      const double shift    = 3 - std::log(4.);
      const double divisor1 = log_term - 2 * nu;
      const double divisor2 = (1 - nu) * log_term + 2 * nu;
      const double divisor3 = (1 - nu) * log_term - 2 + 4 * nu;
      return {2 * pi / (ratio * divisor1) * (1 + shift / divisor1),
              2 * pi / (ratio * divisor2) * (1 + (1 - nu) * shift / divisor2),
              2 * pi / (3 * ratio * std::sqrt(ratio) * divisor3),
              pi / 4 * (1 - nu * (log_term - 2) / divisor3)};
    }
  } // namespace

  KalkerCoefficients kalker_coefficients(const double axis_ratio,
                                         const double poisson_ratio)
  {
    check_positive("Ratio of the semi-axes", axis_ratio);
    if (!(poisson_ratio >= 0 && poisson_ratio <= 0.5))
      reject("Poisson ratio", poisson_ratio, "", "between 0 and 0.5");
    const bool   is_short      = axis_ratio <= 1;
    const double smaller_ratio = is_short ? axis_ratio : 1 / axis_ratio;
    if (smaller_ratio >= 0.1)
      return interpolate(is_short ? short_patch : long_patch,
                         smaller_ratio,
                         poisson_ratio);
    return is_short ? short_patch_limit(smaller_ratio, poisson_ratio)
                    : long_patch_limit(smaller_ratio, poisson_ratio);
  }

  CreepForces kalker_forces(const Creepages          &creepages,
                            const HertzEllipse       &contact,
                            const CombinedElasticity &elasticity,
                            const int                 flow_direction)
  {
    check_finite("Creepage x", creepages.x);
    check_finite("Creepage y", creepages.y);
    check_finite("Spin", creepages.spin, "1/m");
    check_positive("Shear modulus", elasticity.shear_modulus, "Pa");
    check_flow_direction(flow_direction);
    if (contact.load() == 0)
      return {0, 0, 0};
    const KalkerCoefficients kalker =
      kalker_coefficients(contact.half_width_x / contact.half_width_y,
                          elasticity.poisson_ratio);
    const double size = std::sqrt(contact.half_width_x * contact.half_width_y);
    const double stiffness = elasticity.shear_modulus * size * size;
    const double coupling  = flow_direction * size * kalker.C23;
    return {-stiffness * kalker.C11 * creepages.x,
            -stiffness * (kalker.C22 * creepages.y - coupling * creepages.spin),
            -stiffness * (coupling * creepages.y +
                          size * size * kalker.C33 * creepages.spin)};
  }
} // namespace RollingContact::References
