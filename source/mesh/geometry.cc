#include <rolling_contact/mesh/geometry.h>

#include <cmath>
#include <tuple>

namespace RollingContact
{
  double
  crown_depth(const double radius, const double x)
  {
    if (radius == 0.)
      return 0.;
    const double size = std::abs(radius), distance = std::abs(x),
                 joint = std::min(distance, size / 2),
                 depth = joint * joint /
                         (size + std::sqrt(size * size - joint * joint)),
                 slope = joint / std::sqrt(size * size - joint * joint);
    return std::copysign(depth + slope * (distance - joint), radius);
  }



  bool
  BodyGeometry::operator==(const BodyGeometry &other) const
  {
    const auto key = [](const BodyGeometry &body) {
      return std::make_tuple(body.shape,
                             body.rigid,
                             body.radius,
                             body.lateral_radius,
                             body.hub_radius,
                             body.length,
                             body.depth,
                             body.width,
                             body.hub_clamped,
                             body.mesh);
    };
    return key(*this) == key(other);
  }
} // namespace RollingContact
