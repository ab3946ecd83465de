#ifndef rolling_contact_wheelset_found_place_h
#define rolling_contact_wheelset_found_place_h

#include <rolling_contact/scene/scene_parameters.h>
#include <rolling_contact/wheelset/wheelset_report.h>

namespace RollingContact
{
  /**
   * Rules for a scene whose wheels are those of a wheelset in balance. Throws
   * InputError.
   */
  void check_found_place(const SceneParameters &scene);

  /**
   * The equilibrium of the wheelset of a scene in its first case, with wheels
   * on half-spaces whatever its bodies are, without errors of its own. Throws
   * ConvergenceError if there is none, InputError if a profile cannot be read.
   */
  FoundEquilibrium equilibrium_on_half_spaces(const SceneParameters &scene);

  /**
   * The scene of one wheel of an equilibrium, 0 the right-hand one: its side,
   * profiles and radius, place, motion and vertical load, by the entries that
   * give them.
   */
  SceneParameters scene_of_wheel(const SceneParameters  &scene,
                                 const FoundEquilibrium &found,
                                 const unsigned int      wheel);
} // namespace RollingContact

#endif
