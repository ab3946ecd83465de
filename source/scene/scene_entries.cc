#include <fmt/format.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/scene/scene_entries.h>

namespace RollingContact
{
  SceneEntries::SceneEntries(const Situation &first)
    : given(*first.inputs)
    , entries(given.declare({given.analysis}))
    , last(first)
  {}

  void SceneEntries::check(const std::string &entry,
                           const std::string &value,
                           const std::string &place) const
  {
    entries.find(entry, place).check(value, place);
  }

  void SceneEntries::check_variable(const std::string &entry,
                                    const std::string &place) const
  {
    const Entry &row = entries.find(entry, place);
    if (!row.section->varies || !row.section->varies(given))
      {
        std::string sections;
        for (const EntrySection &section : entries.sections())
          if (section.varies && section.varies(given))
            sections += (sections.empty() ? "" : ", ") + section.name;
        sections.replace(sections.rfind(", "), 2, " and ");
        throw InputError(place + entry +
                         " cannot vary between states; take one of "
                         "sections " +
                         sections + '.');
      }
    if (!row.takes_numbers())
      throw InputError(
        place + entry +
        " is not a number; only numbers can vary between states.");
    const std::string why =
      given.finds_place() ? row.why_idle(given) : std::string();
    if (!why.empty())
      throw InputError(place + entry + " has no effect: " + why +
                       "; take another entry.");
  }

  void SceneEntries::set(const std::string &entry, const std::string &value)
  {
    const Entry &row = entries.find(entry);
    row.read(value);
    // the plane of contact is where its load makes the patch
    const bool moves_plane =
      row.renews == Renews::patch &&
      given.profiles.surface_kind == Profiles::SurfaceKind::loaded_plane;
    if (row.renews == Renews::bodies || row.renews == Renews::place ||
        moves_plane)
      {
        const auto as_number = number(value);
        (row.renews == Renews::bodies ? of_bodies : of_place)[entry] =
          as_number ? fmt::format("{}", *as_number) : value;
      }
  }

  std::string SceneEntries::text_of(const SetEntries &entries)
  {
    std::string text;
    for (const auto &[entry, value] : entries)
      text += ", " + entry + " = " + value;
    return text;
  }

  std::string SceneEntries::unit(const std::string &entry) const
  {
    const std::string &unit = entries.find(entry).unit;
    return unit.empty() ? "1" : unit;
  }

  void SceneEntries::check_scene() const
  {
    given.check();
  }

  std::string SceneEntries::bodies_key() const
  {
    std::string key = given.contact.friction_coefficient > 0.
                        ? "with friction"
                        : "without friction";
    key += given.contact.flow() > 0 ? ", flow +x" : ", flow -x";
    key += text_of(of_bodies);
    if (given.analysis.linearises ||
        bodies_follow_profiles(given.profiles, given.wheel, given.rail))
      key += text_of(of_place);
    return key;
  }

  const Situation &SceneEntries::situation()
  {
    last                  = Situation(given, &last);
    const std::string key = bodies_key();
    if (key != checked)
      last.check_bodies();
    checked = key;
    return last;
  }
} // namespace RollingContact
