#ifndef rolling_contact_assessment_uniqueness_warning_h
#define rolling_contact_assessment_uniqueness_warning_h

#include <rolling_contact/patch/uniqueness.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/scene/scene_parameters.h>

#include <array>
#include <string>

namespace RollingContact
{
  /**
   * The worst ratio of uniqueness() over states or steps, where it was
   * and of what.
   */
  struct UniquenessSummary
  {
    /**
     * @p of names the state: "creepage point 3", "t = 1e-3 s".
     */
    void
    add(const Uniqueness     &found,
        const ContactProblem &problem,
        const std::string    &of);

    double                ratio = 0.;
    std::array<double, 2> position{{0., 0.}}; ///< (x, y), m
    std::string           of;
    unsigned int          n_above = 0, n = 0; ///< at the limit or above, all
  };

  /**
   * Warns if several solutions must be expected, of steps @p in_time or of
   * steady states, and says what to do.
   */
  void
  warn_of_non_uniqueness(const SceneParameters   &scene,
                         const bool               in_time,
                         const UniquenessSummary &worst,
                         Log                     &log);

  /**
   * The symbol of the friction coefficient that plots scale with: mu, or mu_s.
   */
  std::string
  scale_of_friction(const SceneParameters &scene);
} // namespace RollingContact

#endif
