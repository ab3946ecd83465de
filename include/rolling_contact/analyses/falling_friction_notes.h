#ifndef rolling_contact_analyses_falling_friction_notes_h
#define rolling_contact_analyses_falling_friction_notes_h

#include <rolling_contact/analyses/scene_parameters.h>
#include <rolling_contact/base/log.h>
#include <rolling_contact/contact/several_solutions.h>

#include <array>
#include <string>

namespace RollingContact
{
  /**
   * The worst ratio of several_solutions() over states or steps, where it was
   * and of what.
   */
  struct WorstRatio
  {
    /**
     * @p of names the state: "creepage point 3", "t = 1e-3 s".
     */
    void
    add(const SeveralSolutions &found,
        const ContactProblem   &problem,
        const std::string      &of);

    double                ratio = 0.;
    std::array<double, 2> position{{0., 0.}}; ///< (x, y), m
    std::string           of;
    unsigned int          n_above = 0, n = 0; ///< at the limit or above, all
  };

  /**
   * Warns if several solutions must be expected, and says what to do.
   */
  void
  warn_of_several_solutions(const SceneParameters &scene,
                            const WorstRatio      &worst,
                            Log                   &log);

  /**
   * The symbol of the friction coefficient that plots scale with: mu, or mu_s.
   */
  std::string
  scale_of_friction(const SceneParameters &scene);
} // namespace RollingContact

#endif
