#ifndef rolling_contact_program_scene_doubts_h
#define rolling_contact_program_scene_doubts_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/tables/table_plan.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Values, defaults and files of a scene that is checked which are hardly
   * meant so, a sentence each for a warning; of a table also the values that
   * its axes or rows take farthest from zero and nearest to it (@p table
   * is its plan). @p given holds the entries that the scene gives,
   * Section/Entry.
   */
  std::vector<std::string> doubts_of(const Situation                &scene,
                                     const std::optional<TablePlan> &table,
                                     std::set<std::string>           given);
} // namespace RollingContact

#endif
