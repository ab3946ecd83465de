#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/falling_half_spaces.h>

#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    void check_bodies(const double                         fall,
                      const std::vector<ShearedHalfSpace> &bodies)
    {
      check_not_negative("Fall of the traction", fall, "Pa s/m");
      for (const ShearedHalfSpace &body : bodies)
        {
          check_positive("Shear modulus", body.shear_modulus, "Pa");
          check_positive("Density", body.density, "kg/m^3");
        }
    }
  } // namespace

  double falling_friction_gain(const double                         fall,
                               const std::vector<ShearedHalfSpace> &bodies)
  {
    check_bodies(fall, bodies);
    double gain = 0.;
    for (const ShearedHalfSpace &body : bodies)
      gain += fall / std::sqrt(body.shear_modulus * body.density);
    return gain;
  }

  double falling_friction_growth(const double                         fall,
                                 const std::vector<ShearedHalfSpace> &bodies,
                                 const double wavelength)
  {
    check_positive("Wavelength", wavelength, "m");
    const double gain = falling_friction_gain(fall, bodies);
    if (gain <= 1.)
      return 0.;
    const double k      = 2 * pi / wavelength;
    const auto   excess = [&](const double logarithm) {
      const double s   = std::exp(logarithm);
      double       sum = -1.;
      for (const ShearedHalfSpace &body : bodies)
        sum += fall * s /
               (body.shear_modulus *
                std::sqrt(k * k + s * s * body.density / body.shear_modulus));
      return sum;
    };
    // without inertia of the bodies it would be slower
    double slowest = 0.;
    for (const ShearedHalfSpace &body : bodies)
      slowest += fall / (body.shear_modulus * k);
    const double lower = -std::log(slowest);
    double       upper = lower + 1.;
    while (excess(upper) < 0.)
      {
        if (upper > lower + 60.) // the gain is 1 but for rounding
          return 0.;
        upper += 1.;
      }
    return std::exp(bracketed_root(excess, lower, upper));
  }
} // namespace RollingContact::References
