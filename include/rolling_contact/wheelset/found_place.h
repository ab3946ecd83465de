#ifndef rolling_contact_wheelset_found_place_h
#define rolling_contact_wheelset_found_place_h

#include <rolling_contact/scene/analysis_traits.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/wheelset/wheelset_report.h>

namespace RollingContact
{
  using SceneRules = decltype(AnalysisTraits::rules);

  /** Rules of Analysis = wheelset. */
  SceneRules rules_of_wheelsets();

  /** Rules of analyses that disturb wheels whose place is found. */
  SceneRules rules_of_disturbed_wheels();

  /**
   * The equilibrium of the wheelset of a scene in its first case, with wheels
   * on half-spaces whatever its bodies are, without errors of its own. Throws
   * ConvergenceError if there is none, InputError if a profile cannot be read.
   */
  FoundEquilibrium equilibrium_on_half_spaces(const Situation &scene);

  /**
   * The scene of one wheel of an equilibrium, 0 the right-hand one: its side,
   * profiles and radius, place, motion and vertical load, as entries give them.
   */
  Situation scene_of_wheel(const Situation        &scene,
                           const FoundEquilibrium &found,
                           const unsigned int      wheel);
} // namespace RollingContact

#endif
