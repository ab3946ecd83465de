#ifndef rolling_contact_input_prm_entries_h
#define rolling_contact_input_prm_entries_h

#include <map>
#include <optional>
#include <set>
#include <string>

namespace RollingContact
{
  /** Values by Section/Entry, or Entry at the top level. */
  using PrmEntries = std::map<std::string, std::string>;

  /** The entries of a parameter file as the program writes it, used.prm. */
  PrmEntries prm_entries(const std::string &text);

  /**
   * The first entry that differs; none if all are the same. Numbers are
   * compared as numbers. `may_differ` holds entries, and sections as
   * "Section/". Not finding an entry on one side is a difference.
   */
  std::optional<std::string>
  changed_entry(const PrmEntries            &old_entries,
                const PrmEntries            &new_entries,
                const std::set<std::string> &may_differ);

  /** Throws InputError naming the changed_entry() and both values. */
  void refuse_changed_entries(const PrmEntries            &old_entries,
                              const PrmEntries            &new_entries,
                              const std::set<std::string> &may_differ);
} // namespace RollingContact

#endif
