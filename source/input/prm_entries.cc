#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_entries.h>

#include <sstream>
#include <vector>

namespace RollingContact
{
  namespace
  {
    bool same_value(const std::string &first, const std::string &second)
    {
      if (first == second)
        return true;
      const auto a = number_of(first), b = number_of(second);
      return a && b && *a == *b;
    }

    bool is_excepted(const std::string           &entry,
                     const std::set<std::string> &may_differ)
    {
      return may_differ.count(entry) > 0 ||
             may_differ.count(entry.substr(0, entry.find('/') + 1)) > 0;
    }

    std::string value_or_none(const PrmEntries  &entries,
                              const std::string &entry)
    {
      const auto found = entries.find(entry);
      return found == entries.end() ? "missing" : '"' + found->second + '"';
    }
  } // namespace

  PrmEntries prm_entries(const std::string &text)
  {
    PrmEntries               entries;
    std::vector<std::string> paths{""}; // of the open sections
    std::istringstream       lines(text);
    for (std::string line; std::getline(lines, line);)
      {
        line                    = trimmed(line);
        const std::size_t space = line.find_first_of(" \t");
        const std::string word  = line.substr(0, space);
        const std::string rest =
          space == std::string::npos ? "" : trimmed(line.substr(space));
        const std::size_t equals = rest.find('=');
        if (word == "subsection")
          paths.push_back(paths.back() + rest + '/');
        else if (word == "end" && paths.size() > 1)
          paths.pop_back();
        else if (word == "set" && equals != std::string::npos)
          entries[paths.back() + trimmed(rest.substr(0, equals))] =
            trimmed(rest.substr(equals + 1));
      }
    return entries;
  }

  std::optional<std::string>
  changed_entry(const PrmEntries            &old_entries,
                const PrmEntries            &new_entries,
                const std::set<std::string> &may_differ)
  {
    PrmEntries all = old_entries;
    all.insert(new_entries.begin(), new_entries.end());
    for (const auto &item : all)
      {
        const std::string &entry  = item.first;
        const auto         before = old_entries.find(entry),
                   now            = new_entries.find(entry);
        const bool is_same        = before != old_entries.end() &&
                             now != new_entries.end() &&
                             same_value(before->second, now->second);
        if (!is_same && !is_excepted(entry, may_differ))
          return entry;
      }
    return std::nullopt;
  }

  void refuse_changed_entries(const PrmEntries            &old_entries,
                              const PrmEntries            &new_entries,
                              const std::set<std::string> &may_differ)
  {
    if (const auto entry = changed_entry(old_entries, new_entries, may_differ))
      throw InputError(
        *entry + " was " + value_or_none(old_entries, *entry) +
        " when the run began and is " + value_or_none(new_entries, *entry) +
        " now: --resume continues the same scene. Set it back, or start "
        "anew without --resume.");
  }
} // namespace RollingContact
