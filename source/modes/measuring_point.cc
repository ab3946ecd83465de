#include <rolling_contact/modes/measuring_point.h>

#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    double distance_between(const std::array<double, 3> &a,
                            const std::array<double, 3> &b)
    {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
  } // namespace

  MeasuringPoint::MeasuringPoint(const BodyPlaces            &places,
                                 const std::array<double, 3> &point,
                                 const double                 radius)
    : nearest{{-1, -1, -1}}
    , nearest_distance(std::numeric_limits<double>::infinity())
  {
    double sum = 0.;
    for (const BodyPlaces::Node &node : places.nodes)
      {
        const double distance = distance_between(node.point, point);
        if (distance < nearest_distance)
          {
            nearest_distance = distance;
            nearest          = node.unknowns;
          }
        if (!(distance < radius))
          continue;
        const double weight = node.mass * (1 - std::pow(distance / radius, 2));
        sum += weight;
        for (unsigned int axis = 0; axis < 3; ++axis)
          if (node.unknowns[axis] >= 0)
            weights[axis].emplace_back(node.unknowns[axis], weight);
      }
    for (unsigned int axis = 0; axis < 3; ++axis)
      {
        if (sum == 0. && nearest[axis] >= 0)
          weights[axis].emplace_back(nearest[axis], 1.);
        for (auto &[unknown, weight] : weights[axis])
          weight /= sum > 0. ? sum : 1.;
      }
  }

  std::vector<double> MeasuringPoint::load(const unsigned int axis,
                                           const std::size_t  n_unknowns) const
  {
    std::vector<double> forces(n_unknowns, 0.);
    for (const auto &[unknown, weight] : weights[axis])
      forces[unknown] += weight;
    return forces;
  }

  double MeasuringPoint::motion(const unsigned int axis,
                                const double      *values) const
  {
    double mean = 0.;
    for (const auto &[unknown, weight] : weights[axis])
      mean += weight * values[unknown];
    return mean;
  }
} // namespace RollingContact
