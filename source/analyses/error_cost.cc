#include <rolling_contact/analyses/error_cost.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * The solved points from the cheapest on, of equally cheap ones the most
     * accurate first.
     */
    std::vector<std::size_t> by_cost(const std::vector<CostedError> &points)
    {
      std::vector<std::size_t> order;
      for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].error))
          order.push_back(i);
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const std::size_t i, const std::size_t j) {
                         if (points[i].cpu_seconds != points[j].cpu_seconds)
                           return points[i].cpu_seconds < points[j].cpu_seconds;
                         return points[i].error < points[j].error;
                       });
      return order;
    }
  } // namespace

  std::vector<std::size_t> pareto_front(const std::vector<CostedError> &points)
  {
    std::vector<std::size_t> front;
    double                   smallest = std::numeric_limits<double>::infinity();
    for (const std::size_t i : by_cost(points))
      if (points[i].error < smallest)
        {
          front.push_back(i);
          smallest = points[i].error;
        }
    return front;
  }

  std::vector<BestOfLevel>
  best_of_levels(const std::vector<CostedError> &points,
                 const std::vector<double>      &levels)
  {
    const std::vector<std::size_t> order = by_cost(points);
    std::vector<BestOfLevel>       best;
    for (const double level : levels)
      {
        const auto first =
          std::find_if(order.begin(), order.end(), [&](const std::size_t i) {
            return points[i].error <= level;
          });
        if (first != order.end())
          best.push_back({level, *first});
      }
    return best;
  }
} // namespace RollingContact
