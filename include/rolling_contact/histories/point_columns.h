#ifndef rolling_contact_histories_point_columns_h
#define rolling_contact_histories_point_columns_h

#include <string>
#include <vector>

namespace RollingContact
{
  struct SceneParameters;

  /**
   * The columns of history.csv with the velocities of the named points, m/s, in
   * the order of StepOutcome::point_velocity.
   */
  std::vector<std::string>
  point_columns(const SceneParameters &scene);
} // namespace RollingContact

#endif
