#ifndef rolling_contact_wheelset_found_place_h
#define rolling_contact_wheelset_found_place_h

#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/entry.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/wheelset/wheelset_report.h>

#include <string>
#include <utility>
#include <vector>

namespace RollingContact
{
  using SceneRules = decltype(AnalysisTraits::rules);

  /** Rules of Analysis = wheelset. */
  SceneRules rules_of_wheelsets();

  /** Whether the wheelsets of a scene are those of a bogie. */
  SceneCondition has_bogie();

  /** Rules of analyses that disturb wheels whose place is found. */
  SceneRules rules_of_disturbed_wheels();

  /**
   * The equilibrium of the wheelset of a scene in its first case, with wheels
   * on half-spaces whatever its bodies are, without errors of its own. Throws
   * ConvergenceError if there is none, InputError if a profile cannot be read.
   */
  FoundEquilibrium equilibrium_on_half_spaces(const Situation &scene);

  /**
   * The entries that place a wheel of an equilibrium, 0 the right-hand one, and
   * their values: shift, yaw, roll, pitch rate, radius of the curve (1e9 m on
   * straight track), vertical load. Units: m, rad, rad/s, N.
   */
  std::vector<std::pair<std::string, double>>
  placing_entries(const Situation        &scene,
                  const FoundEquilibrium &found,
                  const unsigned int      wheel);

  /**
   * The scene of that wheel alone: its side, profiles and radius, and what the
   * placing entries say. Throws InputError if its bodies do not fit there.
   */
  Situation scene_of_wheel(const Situation        &scene,
                           const FoundEquilibrium &found,
                           const unsigned int      wheel);
} // namespace RollingContact

#endif
