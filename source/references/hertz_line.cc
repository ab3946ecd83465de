#include <rolling_contact/base/constants.h>
#include <rolling_contact/references/checks.h>
#include <rolling_contact/references/hertz_line.h>

#include <cmath>

namespace RollingContact::References
{
  double HertzLine::pressure(const double x) const
  {
    if (!(std::abs(x) < half_width))
      return 0;
    const double ratio = x / half_width;
    return max_pressure * std::sqrt((1 - ratio) * (1 + ratio));
  }

  double HertzLine::load_per_length() const
  {
    return pi / 2 * half_width * max_pressure;
  }

  HertzLine hertz_line(const double load_per_length,
                       const double relative_radius,
                       const double contact_modulus)
  {
    check_not_negative("Load per length", load_per_length, "N/m");
    check_positive("Relative radius", relative_radius, "m");
    check_positive("Contact modulus", contact_modulus, "Pa");
    const double half_width =
      std::sqrt(4 * load_per_length * relative_radius / (pi * contact_modulus));
    return hertz_line_of_half_width(half_width,
                                    relative_radius,
                                    contact_modulus);
  }

  HertzLine hertz_line_of_half_width(const double half_width,
                                     const double relative_radius,
                                     const double contact_modulus)
  {
    check_not_negative("Half-width", half_width, "m");
    check_positive("Relative radius", relative_radius, "m");
    check_positive("Contact modulus", contact_modulus, "Pa");
    return {half_width, contact_modulus * half_width / (2 * relative_radius)};
  }
} // namespace RollingContact::References
