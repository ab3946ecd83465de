#ifndef rolling_contact_advice_plausibility_h
#define rolling_contact_advice_plausibility_h

#include <string>
#include <vector>

namespace RollingContact
{
  struct SceneParameters;

  /**
   * Values that are allowed but hardly meant, as Young's modulus of 210 Pa,
   * with what is likely meant: a sentence each, for a warning. Judged by
   * magnitude alone, with room for everything from rubber to diamond, and from
   * models on a table to railways; the histories of section Time at 101 times.
   */
  std::vector<std::string>
  implausible_values(const SceneParameters &scene);
} // namespace RollingContact

#endif
