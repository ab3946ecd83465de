#include <rolling_contact/references/carter.h>
#include <rolling_contact/references/checks.h>

#include <cmath>

namespace RollingContact::References
{
  namespace
  {
    /**
     * x for |x| < half_width, x - sign(x) sqrt(x^2 - half_width^2) outside:
     * the finite Hilbert transform of an elliptic traction, over pi.
     */
    double elliptic_gradient(const double x, const double half_width)
    {
      const double distance = std::abs(x);
      if (distance <= half_width)
        return x;
      const double outside =
        std::sqrt((distance - half_width) * (distance + half_width));
      return x - std::copysign(outside, x);
    }

    double sign(const double value)
    {
      return (value > 0) - (value < 0);
    }
  } // namespace

  Carter::Carter(const HertzLine &contact,
                 const double     relative_radius,
                 const double     friction_coefficient,
                 const double     creepage,
                 const int        flow_direction)
    : contact(contact)
    , relative_radius(relative_radius)
    , friction_coefficient(friction_coefficient)
    , creepage(creepage)
    , flow_direction(flow_direction)
  {
    check_positive("Half-width", contact.half_width, "m");
    check_positive("Maximal pressure", contact.max_pressure, "Pa");
    check_positive("Relative radius", relative_radius, "m");
    check_not_negative("Friction coefficient", friction_coefficient);
    check_finite("Creepage", creepage);
    check_flow_direction(flow_direction);
  }

  double Carter::saturation_creepage() const
  {
    return friction_coefficient * contact.half_width / relative_radius;
  }

  double Carter::stick_half_width() const
  {
    const double saturation = saturation_creepage();
    if (std::abs(creepage) >= saturation)
      return 0;
    return contact.half_width * (1 - std::abs(creepage) / saturation);
  }

  double Carter::stick_middle() const
  {
    return -flow_direction * (contact.half_width - stick_half_width());
  }

  std::pair<double, double> Carter::stick_interval() const
  {
    const double middle = stick_middle();
    return {middle - stick_half_width(), middle + stick_half_width()};
  }

  double Carter::force_ratio() const
  {
    const double ratio = stick_half_width() / contact.half_width;
    return -sign(creepage) * (1 - ratio) * (1 + ratio);
  }

  double Carter::traction(const double x) const
  {
    const double    stick_width = stick_half_width();
    const HertzLine stick{stick_width,
                          contact.max_pressure * stick_width /
                            contact.half_width};
    return -sign(creepage) * friction_coefficient *
           (contact.pressure(x) - stick.pressure(x - stick_middle()));
  }

  double Carter::slip(const double x) const
  {
    const double stick_width = stick_half_width();
    const double offset      = x - stick_middle();
    if (std::abs(offset) < stick_width)
      return 0;
    const double strain = elliptic_gradient(x, contact.half_width) -
                          elliptic_gradient(offset, stick_width);
    return creepage + sign(creepage) * flow_direction * friction_coefficient /
                        relative_radius * strain;
  }
} // namespace RollingContact::References
