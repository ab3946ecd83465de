#include <rolling_contact/studies/force_history.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  ForceHistory
  first_order_limit(const ForceHistory &coarse, const ForceHistory &fine)
  {
    ForceHistory      limit{coarse.step, {}};
    const std::size_t n =
      std::min(coarse.forces.size(), fine.forces.size() / 2);
    for (std::size_t i = 0; i < n; ++i)
      {
        limit.forces.push_back(fine.forces[2 * i + 1]);
        for (unsigned int c = 0; c < 3; ++c)
          limit.forces[i][c] += fine.forces[2 * i + 1][c] - coarse.forces[i][c];
      }
    return limit;
  }



  HistoryErrors
  history_errors(const ForceHistory &history, const ForceHistory &reference)
  {
    double load = 0.;
    for (const auto &force : reference.forces)
      load = std::max(load, force[2]);
    const std::size_t stride = std::lround(history.step / reference.step);
    HistoryErrors     errors;
    for (std::size_t i = 0; i < history.forces.size(); ++i)
      {
        const std::size_t at = (i + 1) * stride - 1;
        if (at >= reference.forces.size())
          break;
        const auto  &value = history.forces[i], &exact = reference.forces[at];
        const double force =
                       std::hypot(value[0] - exact[0], value[1] - exact[1]) /
                       load,
                     normal  = std::abs(value[2] - exact[2]) / load;
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
