#ifndef rolling_contact_fmu_resources_h
#define rolling_contact_fmu_resources_h

#include <optional>
#include <string>

namespace RollingContact::Fmu
{
  /** What is in the folder of resources: a table, or values of a wheelset whose
   * states are solved; the scene; the token. */
  constexpr char table_file[]  = "wheelset.table",
                 values_file[] = "wheelset.values", scene_file[] = "scene.prm",
                 token_file[] = "token.txt";

  /** The content of a file; none if there is no such file. */
  std::optional<std::string> content_of(const std::string &file);
} // namespace RollingContact::Fmu

#endif
