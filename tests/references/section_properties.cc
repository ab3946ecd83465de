#include "section_properties.h"

#include <cmath>

namespace RollingContact::Profiles
{
  SectionProperties
  section_properties(const std::vector<Outline::Point> &polygon)
  {
    double area = 0., first = 0., yy = 0., zz = 0., across = 0.;
    for (std::size_t k = 0; k < polygon.size(); ++k)
      {
        const auto [y0, z0] = polygon[k];
        const auto [y1, z1] = polygon[(k + 1) % polygon.size()];
        const double c      = (y0 * z1 - y1 * z0) / 2;
        area += c;
        first += c * (z0 + z1) / 3;
        across += c * (y0 + y1) / 3;
        zz += c * (z0 * z0 + z0 * z1 + z1 * z1) / 6;
        yy += c * (y0 * y0 + y0 * y1 + y1 * y1) / 6;
      }
    return {std::abs(area),
            first / area,
            std::abs(zz - first * first / area),
            std::abs(yy - across * across / area)};
  }
} // namespace RollingContact::Profiles
