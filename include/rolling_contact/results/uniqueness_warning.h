#ifndef rolling_contact_results_uniqueness_warning_h
#define rolling_contact_results_uniqueness_warning_h

#include <rolling_contact/contact/uniqueness.h>
#include <rolling_contact/run/log.h>
#include <rolling_contact/scene/pair_spec.h>

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
    void add(const Uniqueness     &found,
             const ContactProblem &problem,
             const std::string    &of);

    double                ratio = 0.;
    std::array<double, 2> position{{0., 0.}}; ///< (x, y), m
    std::string           of;
    unsigned int          n_above = 0, n = 0; ///< at the limit or above, all
  };

  /**
   * What may have several solutions.
   */
  enum class SolutionsOf
  {
    steady_states,
    steps_with_inertia,
    steps_without_inertia
  };

  /**
   * Warns if several solutions must be expected, and says what to do.
   */
  void warn_of_non_uniqueness(const unsigned int       dimension,
                              const SolutionsOf        solutions,
                              const UniquenessSummary &worst,
                              Log                     &log);

  /**
   * The symbol of the friction coefficient that plots scale with: mu, or mu_s.
   */
  std::string scale_of_friction(const ContactParameters &contact);
} // namespace RollingContact

#endif
