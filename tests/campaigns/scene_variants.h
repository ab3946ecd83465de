#ifndef rolling_contact_tests_campaigns_scene_variants_h
#define rolling_contact_tests_campaigns_scene_variants_h

#include <string>
#include <utility>
#include <vector>

/**
 * One case of a scene: entries to set, the values that name it, and how it may
 * end.
 */
struct Variant
{
  std::vector<std::string> values;    ///< one of each `vary` line
  std::string              label;     ///< the values as the scene writes them
  std::vector<std::string> arguments; ///< --set Section/Entry=value ...
  int                      expected = 0; ///< exit code
  std::string              reason;       ///< that the message must hold
};

/**
 * A scene of prm/extreme with the cases its comments ask for:
 *   # vary: Section/Entry, Section/Entry = value | value | value
 * sets all entries of a line to one value after the other; several lines give
 * all combinations. Entries that need other values in step are written
 * `Section/Entry=text` inside a value: `0.1 & Contact/Speed=5`.
 *   # expect 2 at value | value: text
 * lists cases that rightly end with that exit code and say so.
 *   # check: mirror, units, monotone
 * asks for further runs: the flow reversed; millimetres and MPa; and the load
 * rising from each case to the next.
 */
struct VariedScene
{
  explicit VariedScene(const std::string &file);

  bool checks(const std::string &name) const;

  std::string              file, name;
  std::vector<Variant>     variants;
  std::vector<std::string> check_names;
};

std::vector<std::string> split(const std::string &text, const char separator);

std::string trimmed(const std::string &text);

#endif
