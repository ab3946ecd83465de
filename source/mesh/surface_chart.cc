#include <rolling_contact/mesh/surface_chart.h>

#include <algorithm>
#include <cmath>

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



  std::vector<double>
  equal_parts(const double begin, const double end, const unsigned int n)
  {
    std::vector<double> points(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      points[i] = begin + (end - begin) * i / n;
    return points;
  }



  std::vector<double>
  break_points(const double begin,
               const double end,
               const double origin,
               const double size)
  {
    std::vector<double> points{begin};
    const int           first = std::ceil((begin - origin) / size);
    for (int k = first; origin + k * size < end; ++k)
      if (origin + k * size > begin + size / 2 &&
          origin + k * size < end - size / 2)
        points.push_back(origin + k * size);
    points.push_back(end);
    return points;
  }
} // namespace RollingContact
