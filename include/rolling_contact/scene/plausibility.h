#ifndef rolling_contact_scene_plausibility_h
#define rolling_contact_scene_plausibility_h

#include <rolling_contact/base/creepages.h>

#include <set>
#include <string>
#include <vector>

namespace RollingContact
{
  struct PairSpec;
  struct SceneParameters;

  /**
   * Values that are allowed but hardly meant, as Young's modulus of 210 Pa,
   * with what is likely meant: a sentence each, for a warning. Judged by
   * magnitude alone, with room for everything from rubber to diamond, and from
   * models on a table to railways; the histories of section Time at 101 times.
   * The @p creepages are those that act.
   */
  std::vector<std::string> implausible_values(const SceneParameters &scene,
                                              const Creepages       &creepages);

  /**
   * What about files of measured profiles is hardly meant, a sentence each for
   * a warning: see Profiles::doubts_of_points(). None where the scene has no
   * profiles.
   */
  std::vector<std::string> doubtful_profiles(const SceneParameters &scene);

  /**
   * Defaults that are hardly meant in a scene that does not give these entries,
   * a sentence each for a warning: a block that is curved like a roller, and in
   * 3D as many elements as a patch in 2D has. @p given holds the entries that
   * the scene gives, Section/Entry, even if by their default.
   */
  std::vector<std::string>
  doubtful_defaults(const SceneParameters       &scene,
                    const std::set<std::string> &given);

  /**
   * A section from a file that is hardly that of a wheel of Wheel/Radius, as
   * its bore would be much larger or smaller beside it than bores are, with the
   * radius that it is likely for: a sentence for a warning, or none. A section
   * does not say its radius, as the axle is no part of it.
   */
  std::vector<std::string> doubtful_bore(const PairSpec &scene);
} // namespace RollingContact

#endif
