#ifndef rolling_contact_studies_force_history_h
#define rolling_contact_studies_force_history_h

#include <array>
#include <cstddef>
#include <vector>

namespace RollingContact
{
  /**
   * Force on the wheel (x, y, and the load) at the times step, 2 step, ...
   * Units: s, N.
   */
  struct ForceHistory
  {
    double                             step = 0.;
    std::vector<std::array<double, 3>> forces;
  };

  /**
   * The limit of two histories, the coarse one with twice the step of the fine
   * one, when errors are of first order in the step: 2 fine - coarse, at the
   * times of the coarse one.
   */
  ForceHistory
  first_order_limit(const ForceHistory &coarse, const ForceHistory &fine);

  /**
   * Differences at the times a history has in common with a reference whose
   * step is a whole part of its own: of the tangential force, as a vector, and
   * of the load, over the largest load of the reference.
   */
  struct HistoryErrors
  {
    double      force_largest = 0., force_mean = 0.; ///< over N
    double      load_largest = 0., load_mean = 0.;   ///< over N
    std::size_t n_times = 0;
  };

  HistoryErrors
  history_errors(const ForceHistory &history, const ForceHistory &reference);
} // namespace RollingContact

#endif
