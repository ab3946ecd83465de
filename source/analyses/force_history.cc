#include <rolling_contact/analyses/force_history.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace RollingContact
{
  namespace
  {
    using Force = std::array<double, 3>;

    /**
     * The force at a time, by the polynomial through the four times around it
     * or all if they are less; none outside of them.
     */
    std::optional<Force> force_at(const ForceHistory &history,
                                  const double        time)
    {
      const std::size_t n     = history.forces.size();
      const double      place = (time + history.lag) / history.step - 1,
                   rounding   = 1e-6;
      if (n == 0 || place < -rounding || place > n - 1 + rounding)
        return {};
      const std::size_t before = std::max(0., std::floor(place) - 1),
                        first  = std::min(before, n < 4 ? 0 : n - 4),
                        last   = std::min(first + 4, n);
      Force force{};
      for (std::size_t i = first; i < last; ++i)
        {
          double weight = 1.;
          for (std::size_t j = first; j < last; ++j)
            if (j != i)
              weight *= (place - j) / (double(i) - j);
          for (unsigned int c = 0; c < 3; ++c)
            force[c] += weight * history.forces[i][c];
        }
      return force;
    }
  } // namespace

  ForceHistory limit_of(const ForceHistory &coarse,
                        const ForceHistory &fine,
                        const double        order)
  {
    ForceHistory limit{coarse.step, {}, coarse.lag};
    const double share = 1 / (std::pow(2., order) - 1);
    for (std::size_t i = 0; i < coarse.forces.size(); ++i)
      {
        std::optional<Force> force = force_at(fine, coarse.time(i));
        if (!force)
          break;
        for (unsigned int c = 0; c < 3; ++c)
          (*force)[c] += share * ((*force)[c] - coarse.forces[i][c]);
        limit.forces.push_back(*force);
      }
    return limit;
  }

  HistoryErrors history_errors(const ForceHistory &history,
                               const ForceHistory &reference)
  {
    double load = 0.;
    for (const auto &force : reference.forces)
      load = std::max(load, force[2]);
    HistoryErrors errors;
    for (std::size_t i = 0; i < history.forces.size(); ++i)
      {
        const std::optional<Force> exact = force_at(reference, history.time(i));
        if (!exact)
          continue;
        const Force &value = history.forces[i];
        const double force = std::hypot(value[0] - (*exact)[0],
                                        value[1] - (*exact)[1]) /
                             load,
                     normal  = std::abs(value[2] - (*exact)[2]) / load;
        errors.force_largest = std::max(errors.force_largest, force);
        errors.load_largest  = std::max(errors.load_largest, normal);
        errors.force_mean += force;
        errors.load_mean += normal;
        ++errors.n_times;
      }
    if (errors.n_times > 0)
      {
        errors.force_mean /= errors.n_times;
        errors.load_mean /= errors.n_times;
      }
    return errors;
  }
} // namespace RollingContact
