#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <nlohmann/json.hpp>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/spelling.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/input/prm_declared.h>

#include <functional>
#include <set>
#include <sstream>

namespace RollingContact
{
  using namespace dealii;

  namespace
  {
    using Json = nlohmann::ordered_json;



    /** X of a help text that ends with "Units: X."; empty for 1. */
    std::string
    unit_of(const std::string &help)
    {
      const std::string mark  = "Units: ";
      const std::size_t found = help.rfind(mark);
      if (found == std::string::npos)
        return "";
      std::string unit = help.substr(found + mark.size());
      unit.erase(unit.find_last_not_of(". ") + 1);
      return unit == "1" ? "" : unit;
    }



    /** A help text without the "Units: X." that it ends with. */
    std::string
    without_unit(const std::string &help)
    {
      const std::size_t found   = help.rfind("Units: ");
      const std::string meaning = help.substr(0, found);
      return meaning.substr(0, meaning.find_last_not_of(' ') + 1);
    }



    /** What stands between two texts; empty if they are not there. */
    std::string
    between(const std::string &text,
            const std::string &begin,
            const std::string &end)
    {
      const std::size_t from = text.find(begin);
      if (from == std::string::npos)
        return "";
      const std::size_t to = text.find(end, from + begin.size());
      return text.substr(from + begin.size(), to - from - begin.size());
    }



    /** "a number from 0 to 1 m" from "[Double 0...1 (inclusive)]". */
    std::string
    range_in_words(const std::string &what,
                   const std::string &pattern,
                   const std::string &unit)
    {
      const std::set<std::string> endless{
        "", "MAX_DOUBLE", "-MAX_DOUBLE", "2147483647", "-2147483648"};
      const std::string numbers = between(pattern, " ", " (inclusive)");
      const std::size_t dots    = numbers.find("...");
      std::string       lower, upper;
      if (dots != std::string::npos)
        {
          const std::size_t begin = numbers.rfind(' ', dots) + 1; // or 0
          lower                   = numbers.substr(begin, dots - begin);
          upper                   = numbers.substr(dots + 3);
        }
      const std::string behind  = unit.empty() ? "" : ' ' + unit;
      const bool        is_from = endless.count(lower) == 0,
                 is_to          = endless.count(upper) == 0;
      if (is_from && is_to)
        return what + " from " + lower + " to " + upper + behind;
      if (is_from)
        return what + " of at least " + lower + behind;
      if (is_to)
        return what + " of at most " + upper + behind;
      return what + (unit.empty() ? "" : " in " + unit);
    }



    /** "`a`, `b` or `c`" from "a|b|c ". */
    std::string
    choices_in_words(const std::string &names)
    {
      std::vector<std::string> words;
      std::istringstream       stream(names);
      for (std::string word; std::getline(stream, word, '|');)
        {
          word.erase(word.find_last_not_of(' ') + 1);
          words.push_back('`' + word + '`');
        }
      std::string text;
      for (std::size_t k = 0; k < words.size(); ++k)
        text += (k == 0                  ? ""
                 : k + 1 == words.size() ? " or "
                                         : ", ") +
                words[k];
      return text;
    }



    /** Of one value: "a number from 0 to 1". */
    std::string
    in_words(const std::string &pattern, const std::string &unit)
    {
      if (pattern.compare(0, 8, "[Double ") == 0)
        return range_in_words("a number", pattern, unit);
      if (pattern.compare(0, 8, "[Integer") == 0)
        return range_in_words("a whole number", pattern, unit);
      if (pattern.compare(0, 5, "[Bool") == 0)
        return "`true` or `false`";
      if (pattern.compare(0, 11, "[Selection ") == 0)
        return choices_in_words(between(pattern, "[Selection ", "]"));
      return pattern;
    }



    /** Of one value or a list: "a list separated by commas, each a number". */
    std::string
    values_in_words(const std::string &pattern, const std::string &unit)
    {
      if (pattern.compare(0, 9, "[List of ") == 0)
        return "a list separated by commas, each " +
               in_words(between(pattern, "<", ">"), unit);
      return in_words(pattern, unit);
    }



    /** Whether a text looks like a number with a decimal comma. */
    bool
    has_decimal_comma(const std::string &pattern, const std::string &value)
    {
      const std::size_t comma = value.find(',');
      return pattern.compare(0, 8, "[Double ") == 0 &&
             comma != std::string::npos &&
             value.find_first_not_of("0123456789.,eE+-") == std::string::npos;
    }
  } // namespace



  std::string
  what_is_allowed(const std::string &pattern, const std::string &unit)
  {
    return "give " + values_in_words(pattern, unit);
  }



  std::string
  entries_as_json(const ParameterHandler &prm)
  {
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::JSON);
    Json                              all      = Json::parse(text.str());
    const std::function<void(Json &)> describe = [&](Json &section) {
      for (Json &child : section)
        if (!child.contains("pattern_description"))
          describe(child);
        else
          {
            const std::string help    = child["documentation"],
                              pattern = child["pattern_description"],
                              unit    = unit_of(help);
            const bool takes_all =
              pattern == Patterns::Anything().description();
            Json entry;
            entry["default"] = child["default_value"];
            entry["meaning"] = without_unit(help);
            entry["unit"]    = unit;
            entry["allowed"] = takes_all ? "" : values_in_words(pattern, unit);
            child            = entry;
          }
    };
    describe(all);
    return all.dump(2) + '\n';
  }



  DeclaredEntries::DeclaredEntries(const ParameterHandler &prm)
  {
    std::ostringstream text;
    prm.print_parameters(text, ParameterHandler::JSON);
    const std::function<void(const Json &, const std::string &)> add =
      [&](const Json &node, const std::string &path) {
        for (const auto &[name, child] : node.items())
          if (child.contains("pattern_description"))
            entries[path + name] = {child["pattern_description"],
                                    unit_of(child["documentation"]),
                                    child["default_value"]};
          else
            add(child, path + name + '/');
      };
    add(Json::parse(text.str()), "");
  }



  void
  DeclaredEntries::check_exists(const PrmEntry &given) const
  {
    if (entries.count(given.path) > 0)
      return;
    std::vector<std::string> known;
    for (const auto &entry : entries)
      known.push_back(entry.first);
    const std::string meant = did_you_mean(likely_meant(given.path, known));
    throw InputError(given.place + "there is no entry " + quotable(given.path) +
                     "; " + (meant.empty() ? "see" : meant + " See") +
                     " --print-parameters.");
  }



  void
  DeclaredEntries::check(const PrmEntry &given) const
  {
    check_exists(given);
    const Entry &entry = entries.at(given.path);
    if (Patterns::pattern_factory(entry.pattern)->match(given.value))
      return;
    throw InputError(given.place + given.path + " = " + quotable(given.value) +
                     ": " + what_is_allowed(entry.pattern, entry.unit) +
                     (has_decimal_comma(entry.pattern, given.value)
                        ? "; decimals take a point."
                        : "."));
  }



  const std::string &
  DeclaredEntries::unit(const std::string &path) const
  {
    return entries.at(path).unit;
  }



  const std::string &
  DeclaredEntries::pattern(const std::string &path) const
  {
    return entries.at(path).pattern;
  }



  bool
  DeclaredEntries::is_default(const PrmEntry &given) const
  {
    const std::string &value = entries.at(given.path).default_value;
    if (given.value == value)
      return true;
    const std::optional<double> number_given   = number(given.value),
                                number_default = number(value);
    return number_given && number_default && *number_given == *number_default;
  }



  void
  DeclaredEntries::check_section(const PrmEntry &given) const
  {
    std::set<std::string> known;
    for (const auto &entry : entries)
      known.insert(entry.first.substr(0, entry.first.rfind('/')));
    for (const auto &entry : entries)
      if (entry.first.find('/') == std::string::npos)
        known.erase(entry.first);
    if (known.count(given.path) > 0)
      return;
    const std::string meant =
      did_you_mean(likely_meant(given.path, {known.begin(), known.end()}));
    throw InputError(
      given.place + "there is no section " + quotable(given.path) + "; " +
      (meant.empty() ? "see" : meant + " See") + " --print-parameters.");
  }
} // namespace RollingContact
