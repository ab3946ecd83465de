#include <boost/math/quadrature/gauss.hpp>

#include <rolling_contact/scene/travelled_distance.h>

#include <cmath>

namespace RollingContact
{
  TravelledDistance::TravelledDistance(const TimeFunction &speed,
                                       const double        panel)
    : speed(speed)
    , panel(panel)
  {}

  double TravelledDistance::between(const double begin, const double end) const
  {
    return boost::math::quadrature::gauss<double, 7>::integrate(
      [&](const double time) { return speed.value(time); }, begin, end);
  }

  double TravelledDistance::value(const double time) const
  {
    if (speed.is_constant())
      return speed.value(0.) * time;
    const auto n = static_cast<std::size_t>(time / panel);
    while (at_panels.size() <= n)
      at_panels.push_back(
        at_panels.back() +
        between((at_panels.size() - 1) * panel, at_panels.size() * panel));
    return at_panels[n] + between(n * panel, time);
  }
} // namespace RollingContact
