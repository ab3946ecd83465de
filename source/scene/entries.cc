#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/spelling.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    /** "; see" or "; did you mean ...? See" in front of where to look. */
    [[noreturn]] void throw_unknown(const PrmEntry                 &given,
                                    const std::string              &kind,
                                    const std::vector<std::string> &known)
    {
      const std::string meant = did_you_mean(likely_meant(given.path, known));
      throw InputError(given.place + "there is no " + kind + ' ' +
                       quotable(given.path) + "; " +
                       (meant.empty() ? "see" : meant + " See") +
                       " --print-parameters.");
    }
  } // namespace

  Entries::Entries()
  {
    section("");
  }

  EntrySection &Entries::section(const std::string &name)
  {
    for (EntrySection &known : all_sections)
      if (known.name == name)
        return *(current = &known);
    all_sections.emplace_back().name = name;
    return *(current = &all_sections.back());
  }

  Entry &Entries::parsed(const std::string &name,
                         const Entry::Kind  kind,
                         const std::string &default_text,
                         const std::string &unit,
                         const std::function<void(const std::string &)> &read)
  {
    Entry &entry         = all.emplace_back();
    entry.section        = current;
    entry.name           = name;
    entry.unit           = unit;
    entry.default_text   = default_text;
    entry.kind           = kind;
    entry.read           = read;
    entry.renews         = current->renews;
    entry.free_on_resume = current->free_on_resume;
    if (kind == Entry::Kind::integer)
      entry.at_least(0.);
    by_path[entry.path()] = &entry;
    return entry;
  }

  Entry &Entries::add(const std::string     &name,
                      std::optional<double> &value,
                      const std::string     &unit)
  {
    const std::string path = current->name + '/' + name;
    return parsed(name,
                  Entry::Kind::numbers,
                  "",
                  unit,
                  [&value, path, unit](const std::string &text) {
                    const std::optional<double> given = number(text);
                    if (!given && !text.empty())
                      throw InputError(path + " = " + quotable(text) +
                                       ": give a number" +
                                       (unit == "1" ? "" : " in " + unit) +
                                       ", or leave it empty" +
                                       (text.find(',') != std::string::npos
                                          ? "; decimals take a point."
                                          : "."));
                    value = given;
                  });
  }

  Entry &Entries::add_automatic(const std::string     &name,
                                std::optional<double> &value,
                                const std::string     &unit)
  {
    const std::string word = "automatic";
    const auto read = [&value, path = current->name + '/' + name, unit, word](
                        const std::string &text) {
      const std::optional<double> given = number(text);
      if (!given && text != word)
        throw InputError(path + " = " + quotable(text) + ": give a number" +
                         (unit == "1" ? "" : " in " + unit) + ", or `" + word +
                         "`.");
      value = given;
    };
    return parsed(name, Entry::Kind::number, word, unit, read).or_word(word);
  }

  Entry &Entries::list(const std::string   &name,
                       std::vector<double> &values,
                       const std::string   &default_text,
                       const std::string   &unit)
  {
    const std::string path = current->name + '/' + name;
    return parsed(name,
                  Entry::Kind::numbers,
                  default_text,
                  unit,
                  [&values, path, default_text](const std::string &text) {
                    values = text.empty() && default_text.empty()
                               ? std::vector<double>()
                               : number_list(path, text);
                  });
  }

  std::string Entries::form_of_lists()
  {
    return number_list_form;
  }

  void Entries::declare(ParameterHandler &prm) const
  {
    for (const Entry &entry : all)
      {
        if (!entry.section->name.empty())
          prm.enter_subsection(entry.section->name);
        prm.declare_entry(entry.name,
                          entry.default_text,
                          *entry.pattern(),
                          entry.documentation());
        prm.add_action(entry.name, entry.read);
        if (!entry.section->name.empty())
          prm.leave_subsection();
      }
  }

  const Entry &Entries::find(const std::string &path,
                             const std::string &place) const
  {
    const auto found = by_path.find(path);
    if (found != by_path.end())
      return *found->second;
    std::vector<std::string> known;
    for (const auto &row : by_path)
      known.push_back(row.first);
    throw_unknown({path, "", place}, "entry", known);
  }

  void Entries::check_section(const PrmEntry &given) const
  {
    std::set<std::string> known;
    for (const EntrySection &section : all_sections)
      if (!section.name.empty())
        known.insert(section.name);
    if (known.count(given.path) == 0)
      throw_unknown(given, "section", {known.begin(), known.end()});
  }

  std::string entries_as_json(const Entries &entries)
  {
    // those outside of sections first, then by section, each in alphabet
    std::map<std::pair<std::string, std::string>, const Entry *> sorted;
    for (const Entry &entry : entries.rows())
      sorted[{entry.section->name, entry.name}] = &entry;
    nlohmann::ordered_json all;
    for (const auto &[path, entry] : sorted)
      {
        auto &json =
          path.first.empty() ? all[path.second] : all[path.first][path.second];
        json["default"] = entry->default_text;
        json["meaning"] = entry->help;
        json["unit"]    = entry->unit == "1" ? "" : entry->unit;
        json["allowed"] = entry->allowed();
      }
    return all.dump(2) + '\n';
  }
} // namespace RollingContact
