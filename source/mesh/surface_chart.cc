#include <rolling_contact/mesh/surface_chart.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  double crown_depth(const double radius, const double x)
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

  unsigned int fewest_parts(const double length, const double longest)
  {
    const double rounding = 1e-9;
    return std::max(1., std::ceil(length / longest - rounding));
  }

  double CoarseCells::length_at(const double position) const
  {
    return allowed ? std::max(size, std::min(allowed(position), largest))
                   : size;
  }

  std::vector<double>
  growing_parts(const double begin, const double end, const CoarseCells &cells)
  {
    const double rounding = 1e-6; // of a cell
    const double distance = std::abs(end - begin), way = end > begin ? 1. : -1.;
    std::vector<double> lengths{0.}; // of all cells so far
    for (double length = cells.size;
         lengths.back() < distance - rounding * length;)
      {
        length = cells.length_at(begin + way * lengths.back());
        lengths.push_back(lengths.back() + length);
      }
    const double        scale = distance / lengths.back();
    std::vector<double> points;
    for (const double length : lengths)
      points.push_back(begin + way * scale * length);
    points.back() = end;
    return points;
  }

  std::vector<double>
  break_points(const double begin, const double end, const CoarseCells &cells)
  {
    const double size = cells.size;
    if (cells.equal)
      return equal_parts(begin, end, fewest_parts(end - begin, size));
    const double half_core =
      cells.allowed ? cells.half_core : end - begin + std::abs(cells.origin);
    const int           n_core = std::ceil(half_core / size);
    std::vector<double> points;
    const auto lattice   = [&](const int k) { return cells.origin + k * size; };
    const auto is_inside = [&](const double point) {
      return point > begin + size / 2 && point < end - size / 2;
    };
    if (is_inside(lattice(-n_core)))
      {
        points = growing_parts(lattice(-n_core), begin, cells);
        std::reverse(points.begin(), points.end());
        points.pop_back();
      }
    else
      points = {begin};
    for (int k = -n_core; k <= n_core; ++k)
      if (is_inside(lattice(k)))
        points.push_back(lattice(k));
    if (is_inside(lattice(n_core)))
      {
        const auto beyond = growing_parts(lattice(n_core), end, cells);
        points.insert(points.end(), beyond.begin() + 1, beyond.end());
      }
    else
      points.push_back(end);
    return points;
  }
} // namespace RollingContact
