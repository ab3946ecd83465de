#include "annular_plate.h"

#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/references/checks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace RollingContact::References
{
  namespace
  {
    using Matrix = std::array<std::array<double, 4>, 4>;

    /** J, Y, I, K of order n and their first derivatives. */
    std::array<std::array<double, 2>, 4> bessel(const unsigned int n,
                                                const double       x)
    {
      using namespace boost::math;
      return {{{{cyl_bessel_j(n, x), cyl_bessel_j_prime(n, x)}},
               {{cyl_neumann(n, x), cyl_neumann_prime(n, x)}},
               {{cyl_bessel_i(n, x), cyl_bessel_i_prime(n, x)}},
               {{cyl_bessel_k(n, x), cyl_bessel_k_prime(n, x)}}}};
    }

    /** By elimination with pivots; the columns are of like size. */
    double determinant(Matrix matrix)
    {
      double result = 1.;
      for (unsigned int k = 0; k < 4; ++k)
        {
          unsigned int pivot = k;
          for (unsigned int i = k + 1; i < 4; ++i)
            if (std::abs(matrix[i][k]) > std::abs(matrix[pivot][k]))
              pivot = i;
          if (matrix[pivot][k] == 0.)
            return 0.;
          if (pivot != k)
            {
              std::swap(matrix[pivot], matrix[k]);
              result = -result;
            }
          result *= matrix[k][k];
          for (unsigned int i = k + 1; i < 4; ++i)
            for (unsigned int j = 4; j-- > k;)
              matrix[i][j] -= matrix[i][k] / matrix[k][k] * matrix[k][j];
        }
      return result;
    }

    /** Zero at the wave numbers @p k of free vibrations. */
    double
    condition(const AnnularPlate &plate, const unsigned int n, const double k)
    {
      const double x = k * plate.inner_radius, y = k * plate.outer_radius,
                   nu = plate.poisson_ratio, turns = n * n / (y * y);
      const auto inside = bessel(n, x), outside = bessel(n, y);
      Matrix     matrix;
      for (unsigned int l = 0; l < 4; ++l)
        {
          const double w = outside[l][0], slope = outside[l][1],
                       sign = l < 2 ? 1. : -1., // lap w = -sign w
            curvature       = -slope / y + (turns - sign) * w;
          const std::array<double, 4> column{
            {inside[l][0],
             inside[l][1],
             curvature + nu * (slope / y - turns * w),
             -sign * slope - (1 - nu) * turns * (slope - w / y)}};
          double largest = 0.;
          for (const double value : column)
            largest = std::max(largest, std::abs(value));
          for (unsigned int i = 0; i < 4; ++i)
            matrix[i][l] = column[i] / largest;
        }
      return determinant(matrix);
    }
  } // namespace

  std::vector<double>
  AnnularPlate::frequencies(const unsigned int n_diameters,
                            const unsigned int n_frequencies) const
  {
    check_positive("Inner radius", inner_radius, "m");
    check_positive("Width of the annulus", outer_radius - inner_radius, "m");
    check_positive("Thickness", thickness, "m");
    check_elasticity(young_modulus, poisson_ratio);
    check_positive("Density", density, "kg/m^3");
    const auto function = [&](const double k) {
      return condition(*this, n_diameters, k);
    };
    const double stiffness = young_modulus * std::pow(thickness, 3) /
                             (12 * (1 - poisson_ratio * poisson_ratio));
    const double step = pi / (outer_radius - inner_radius) / 40; // of the roots
    std::vector<double> result;
    double              k = step, value = function(k);
    while (result.size() < n_frequencies)
      {
        const double next = k + step, next_value = function(next);
        if (value * next_value < 0.)
          {
            const double root = bracketed_root(function, k, next);
            result.push_back(root * root / (2 * pi) *
                             std::sqrt(stiffness / (density * thickness)));
          }
        k     = next;
        value = next_value;
      }
    return result;
  }
} // namespace RollingContact::References
