#include "slender_bodies.h"

#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/bracketed_root.h>
#include <rolling_contact/references/checks.h>

#include <algorithm>
#include <cmath>

namespace RollingContact::References
{
  namespace
  {} // namespace

  double cantilever_compliance(const Bar &bar)
  {
    check_positive("Length", bar.length, "m");
    const double shear = 5. / 6 * bar.shear_modulus * bar.area();
    return std::pow(bar.length, 3) /
             (3 * bar.young_modulus * bar.second_moment()) +
           bar.length / shear;
  }

  double cantilever_frequency(const Bar &bar, const unsigned int number)
  {
    check_positive("Length", bar.length, "m");
    check_positive("Number of the frequency", number);
    const double middle = (number - 0.5) * pi;
    // one root within pi/2 of each odd multiple of pi/2
    const double root = bracketed_root(
      [](const double x) { return std::cos(x) + 1 / std::cosh(x); },
      middle - 0.5,
      middle + 0.5);
    return root * root / (2 * pi * bar.length * bar.length) *
           std::sqrt(bar.young_modulus * bar.second_moment() /
                     (bar.density * bar.area()));
  }

  double torsional_stiffness(const Bar &bar)
  {
    const double a = std::max(bar.width, bar.depth),
                 b = std::min(bar.width, bar.depth);
    check_positive("Width", b, "m");
    double sum = 0.;
    for (int n = 101; n > 0; n -= 2) // the rest is below 1e-10
      sum += std::tanh(n * pi * a / (2 * b)) / std::pow(n, 5);
    return bar.shear_modulus * a * b * b * b *
           (1. / 3 - 64 / std::pow(pi, 5) * b / a * sum);
  }

  double free_ring_frequency(const Bar         &section,
                             const double       radius,
                             const unsigned int n_diameters)
  {
    check_positive("Radius", radius, "m");
    const double n = n_diameters;
    return n * (n * n - 1) / std::sqrt(n * n + 1) / (2 * pi * radius * radius) *
           std::sqrt(section.young_modulus * section.second_moment() /
                     (section.density * section.area()));
  }

  double winkler_beam_compliance(const double bending_stiffness,
                                 const double stiffness)
  {
    check_positive("Bending stiffness", bending_stiffness, "N m^2");
    check_positive("Stiffness of the foundation", stiffness, "N/m^2");
    return std::pow(stiffness / (4 * bending_stiffness), 0.25) /
           (2 * stiffness);
  }
} // namespace RollingContact::References
