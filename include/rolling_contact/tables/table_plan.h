#ifndef rolling_contact_tables_table_plan_h
#define rolling_contact_tables_table_plan_h

#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/scene/situation.h>

#include <filesystem>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Which entries of a table take which values: the states of a full grid in
   * the order of its axes, the last one fastest, or the rows of a file.
   */
  struct TableStates
  {
    std::vector<TableAxis>           axes; ///< of a grid; none for rows
    std::vector<std::string>         entries, places; ///< places for messages
    std::vector<std::vector<double>> values;          ///< of a state, by entry

    /** The last entries, which were found from the others. */
    std::size_t n_found = 0;

    /** Texts by which states are known, in columns of these names. */
    std::vector<std::pair<std::string, std::vector<std::string>>> titles;

    /**
     * "Contact/Normal load = 60000, Contact/Creepage x = 0.001", without what
     * was found; titles stand first, and alone if one is `name`.
     */
    std::string name(const std::size_t state) const;
  };

  /**
   * @p folder: where a file of rows is. Throws InputError if section Table says
   * something impossible, or more than a million states.
   */
  TableStates table_states(const TableParameters       &table,
                           const std::filesystem::path &folder);

  /**
   * States that share bodies but for the size of their patch, in the order in
   * which they are solved: neighbours differ by one step along one axis.
   */
  struct TableGroup
  {
    std::string              bodies; ///< SceneEntries::bodies_key()
    std::vector<std::size_t> states;
  };

  /**
   * The states of a table and how they are solved.
   */
  struct TablePlan : public TableStates
  {
    std::vector<std::string> units; ///< of the entries
    std::vector<TableGroup>  groups;

    /**
     * Set the entries of a state.
     */
    void set(const std::size_t state, SceneEntries &entries) const;
  };

  /**
   * Throws InputError if an entry is unknown or no number, or a value is not
   * allowed, alone or together with others, in any of the states.
   */
  TablePlan plan_table(const Situation &scene, const TableStates &states);

  /** The states are those of section Table. */
  TablePlan plan_table(const Situation &scene);

  /**
   * A number as an entry takes it, which reads as the same number again.
   */
  std::string exact_text(const double value);
} // namespace RollingContact

#endif
