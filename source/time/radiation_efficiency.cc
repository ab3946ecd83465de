#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/bessel_prime.hpp>

#include <rolling_contact/base/constants.h>
#include <rolling_contact/time/radiation_efficiency.h>

#include <cmath>

namespace RollingContact::Sound
{
  double axial_efficiency_of_wheel(const unsigned int nodal_diameters,
                                   const double       radius,
                                   const double       speed_of_sound,
                                   const double       frequency)
  {
    const double n        = nodal_diameters,
                 critical = speed_of_sound *
                            (1.9 + 1.015 * n - 0.0189 * n * n) /
                            (2 * pi * radius);
    return 1 / (1 + std::pow(critical / frequency, 2 * n + 4));
  }

  double radial_efficiency_of_wheel(const unsigned int nodal_diameters,
                                    const double       radius,
                                    const double       width,
                                    const double       speed_of_sound,
                                    const double       frequency)
  {
    const double k = 2 * pi * frequency / speed_of_sound, x = 2 * k * radius;
    double       sum = 0.;
    for (unsigned int order = 2 * nodal_diameters + 1;; order += 2)
      {
        const double term = boost::math::cyl_bessel_j(order, x);
        sum += term;
        if (order > x && std::abs(term) <= 1e-15 * std::abs(sum))
          break;
      }
    const double s = k * width / 2 * sum;
    return s / (1 + s);
  }

  double efficiency_of_cylinder(const double radius,
                                const double speed_of_sound,
                                const double frequency)
  {
    const double x = 2 * pi * frequency / speed_of_sound * radius,
                 j = boost::math::cyl_bessel_j_prime(1, x),
                 y = boost::math::cyl_neumann_prime(1, x);
    return 2 / (pi * x * (j * j + y * y));
  }

  double equivalent_radius(const double section,
                           const double width,
                           const double normal_length)
  {
    const double dipole = section + pi * width * width / 4;
    return std::cbrt(dipole * dipole / (4 * pi * normal_length));
  }
} // namespace RollingContact::Sound
