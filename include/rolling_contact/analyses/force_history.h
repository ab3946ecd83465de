#ifndef rolling_contact_analyses_force_history_h
#define rolling_contact_analyses_force_history_h

#include <array>
#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * Force on the wheel (x, y, and the load) at the times step, 2 step, ...,
   * each less the lag: (1 - theta) step with the theta-scheme, whose reactions
   * act at theta of a step. Units: s, N.
   */
  struct ForceHistory
  {
    double                             step = 0.;
    std::vector<std::array<double, 3>> forces;
    double                             lag = 0.;

    double time(const std::size_t i) const
    {
      return (i + 1) * step - lag;
    }
  };

  /**
   * The limit of two histories, the coarse one with twice the step of the fine
   * one, when errors are of this order in the step, at the times of the coarse
   * one: fine + (fine - coarse) / (2^order - 1).
   */
  ForceHistory limit_of(const ForceHistory &coarse,
                        const ForceHistory &fine,
                        const double        order);

  /**
   * Differences from a reference, interpolated by cubics, at the times of a
   * history which lie within those of the reference: of the tangential force,
   * as a vector, and of the load, over the largest load of the reference.
   */
  struct HistoryErrors
  {
    double      force_largest = 0., force_mean = 0.; ///< over N
    double      load_largest = 0., load_mean = 0.;   ///< over N
    std::size_t n_times = 0;
  };

  HistoryErrors history_errors(const ForceHistory &history,
                               const ForceHistory &reference);
} // namespace RollingContact

#endif
