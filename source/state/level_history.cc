#include <rolling_contact/state/level_history.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    double difference(const LevelValues &a, const LevelValues &b)
    {
      const auto relative = [&](const LevelValues::Quantity quantity) {
        const double scale = std::abs(a.values[quantity]);
        return scale > 0.
                 ? std::abs(a.values[quantity] - b.values[quantity]) / scale
                 : 0.;
      };
      const double traction = a.friction_force > 0.
                                ? std::hypot(a.values[LevelValues::force_x] -
                                               b.values[LevelValues::force_x],
                                             a.values[LevelValues::force_y] -
                                               b.values[LevelValues::force_y]) /
                                    a.friction_force
                                : 0.;
      return std::max({traction,
                       relative(LevelValues::normal_force),
                       relative(LevelValues::approach)});
    }

    /**
     * Factor from one change to the next of the quantity that changes most.
     */
    double shrinkage(const std::vector<LevelValues> &levels,
                     const std::size_t               n)
    {
      if (n < 3)
        return 1. / 3;
      const double before = difference(levels[n - 2], levels[n - 3]),
                   now    = difference(levels[n - 1], levels[n - 2]);
      return before > 0. ? std::clamp(now / before, 1. / 8, 2. / 3) : 1. / 3;
    }

    /**
     * The limit of the first @p n levels.
     */
    LevelValues extrapolated(const std::vector<LevelValues> &levels,
                             const std::size_t               n)
    {
      const double factor = shrinkage(levels, n),
                   weight = factor / (1 - factor);
      LevelValues limit   = levels[n - 1];
      for (std::size_t q = 0; q < limit.values.size(); ++q)
        limit.values[q] +=
          weight * (levels[n - 1].values[q] - levels[n - 2].values[q]);
      return limit;
    }
  } // namespace

  std::optional<double> LevelHistory::change() const
  {
    if (levels.size() < 2)
      return {};
    return difference(levels.back(), levels[levels.size() - 2]);
  }

  std::optional<LevelLimit> LevelHistory::limit() const
  {
    const std::size_t n = levels.size();
    if (n < 2)
      return {};
    LevelLimit result;
    result.limit       = extrapolated(levels, n);
    result.value_error = difference(levels.back(), result.limit);
    result.limit_error =
      n < 3 ? result.value_error
            : difference(result.limit, extrapolated(levels, n - 1));
    return result;
  }
} // namespace RollingContact
