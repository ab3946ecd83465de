#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/evolution/evolution_parameters.h>
#include <rolling_contact/scene/entries.h>

#include <algorithm>
#include <tuple>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<WearingBodies>> named_bodies{
      {"wheel", WearingBodies::wheel},
      {"rail", WearingBodies::rail},
      {"both", WearingBodies::both}};

    [[noreturn]] void refuse(const std::string &entry, const std::string &what)
    {
      throw InputError("Evolution/" + entry + what);
    }

    void check_above_zero(const std::string           &entry,
                          const std::optional<double> &value,
                          const std::string           &unit)
    {
      if (value && !(*value > 0.))
        refuse(entry, " = " + text_of(*value) + ": give " + unit + " above 0.");
    }

    void check_given(const std::string           &entry,
                     const std::optional<double> &value,
                     const bool                   is_wanted,
                     const std::string           &unit)
    {
      check_above_zero(entry, value, unit);
      if (is_wanted && !value)
        refuse(entry, " is empty: give " + unit + ", which end the evolution.");
      if (!is_wanted && value)
        refuse(entry,
               " = " + text_of(*value) +
                 ": it has no effect on bodies that do not wear; leave it "
                 "empty, or see Evolution/Bodies.");
    }
  } // namespace

  const Damage::WearLaw &EvolutionParameters::wear_law() const
  {
    const auto &laws = Damage::wear_laws();
    return *std::find_if(laws.begin(), laws.end(), [&](const auto &it) {
      return it.name == law;
    });
  }

  std::string EvolutionParameters::text_of_way(const double share) const
  {
    std::string text;
    if (wears_wheel())
      text = significant(share * distance.value() / 1e3, 6) + " km";
    if (wears_rail())
      text += (text.empty() ? "" : " and ") +
              significant(share * passages.value(), 6) + " passages";
    return text;
  }

  void EvolutionParameters::check() const
  {
    for (const auto &[entry, value] :
         {std::tuple("Tolerance", tolerance),
          std::tuple("Largest step", largest_step)})
      if (!(value >= 1e-8 && value <= 1e-3))
        refuse(entry,
               " = " + text_of(value) + ": give a depth from 1e-8 to 1e-3 m.");
    if (smoothing && !(*smoothing >= 0. && *smoothing <= 0.02))
      refuse("Smoothing",
             " = " + text_of(*smoothing) +
               ": give 0 to 0.02 m, or `automatic`.");
    for (const auto &[entry, value] :
         {std::pair("Largest depth", largest_depth),
          std::pair("Least flange thickness", least_thickness),
          std::pair("Largest flange height", largest_height),
          std::pair("Least qR", least_qr)})
      check_above_zero(entry, value, "metres");
    if (!wears_wheel())
      for (const auto &[entry, value] :
           {std::pair("Least flange thickness", least_thickness),
            std::pair("Largest flange height", largest_height),
            std::pair("Least qR", least_qr)})
        if (value)
          refuse(entry,
                 " = " + text_of(*value) +
                   ": wheels do not wear; leave it empty, or see "
                   "Evolution/Bodies.");
  }

  void EvolutionParameters::check_way() const
  {
    check_given("Distance", distance, wears_wheel(), "metres");
    check_given("Passages", passages, wears_rail(), "passages of wheelsets");
  }

  void EvolutionParameters::declare(Entries &entries)
  {
    EntrySection &section = entries.section("Evolution");
    section.read_by_analyses("profile evolution");
    declare_duty(entries);
    declare_steps(entries);
    declare_ends(entries);
  }

  void EvolutionParameters::declare_duty(Entries &entries)
  {
    entries.add("File of rows", file_of_rows).help =
      "CSV file of the duty, relative to the scene. Its columns are entries "
      "of sections Wheelset and Contact, `share` of the distance, and `name`. "
      "Empty: the scene itself all the way.";
    entries.add("Both directions", both_directions).help =
      "Whether each row runs as often to one side as to the other, so that "
      "both wheels have one profile, and both rails. false: each side has its "
      "own.";
    entries.choice("Bodies", bodies, named_bodies).help =
      "Which profiles wear: `wheel`, `rail` "
      "or `both`.";
    std::vector<NamedValue<std::string>> laws;
    for (const Damage::WearLaw &it : Damage::wear_laws())
      laws.push_back({it.name, it.name});
    entries.choice("Law", law, laws).help =
      "Law of wear, with the constants of section Wear: `usfd`, `archard` or "
      "`t-gamma`.";
    entries.add("Distance", distance, "m").help =
      "Distance that the wheels roll, for wheels that wear.";
    entries.add("Passages", passages, "1").help =
      "Number of passages of wheelsets over the rails, for rails that wear.";
  }

  void EvolutionParameters::declare_steps(Entries &entries)
  {
    entries.add("Tolerance", tolerance, "m").help =
      "Largest difference between the depth of a step and that of two half "
      "steps. The depth that is taken is extrapolated from both and much more "
      "exact.";
    entries.add("Largest step", largest_step, "m").help =
      "Largest depth that wears off in one step.";
    entries.add("Equal steps", equal_steps, "1").between(0, 100000).help =
      "Number of steps of equal length, in place of those by Tolerance; 0: by "
      "Tolerance.";
    entries
      .choice("Scheme",
              is_implicit,
              std::vector<NamedValue<bool>>{{"implicit", true},
                                            {"explicit", false}})
      .help =
      "How a step takes account of the wear that it makes. `implicit`: stable "
      "at any step; `explicit`: oscillates where steps are deep, and is there "
      "to compare.";
    entries.add_automatic("Smoothing", smoothing, "m").help =
      "How far the wear of a step is spread to both sides, at least over one "
      "line of nodes. `automatic`: half of the largest distance between "
      "neighbouring places of wear, among those less than 5 mm apart, because "
      "states between the rows of the duty would wear what lies between. "
      "Profiles themselves are not smoothed.";
    entries.add("Threads", threads, "1")
      .between(0, 1024)
      .resumed_if(in_all_scenes)
      .help =
      "Number of rows of the duty that are solved at once; 0: as many as "
      "there are processors. Results do not depend on it.";
  }

  void EvolutionParameters::declare_ends(Entries &entries)
  {
    entries.add("Largest depth", largest_depth, "m").help =
      "Depth of wear at which the evolution ends; empty: no limit.";
    entries.add("Least flange thickness", least_thickness, "m").help =
      "Flange thickness Sd at which the evolution ends, see "
      "doc/howto/evolution.md; empty: no limit.";
    entries.add("Largest flange height", largest_height, "m").help =
      "Flange height Sh at which the evolution ends; empty: no limit.";
    entries.add("Least qR", least_qr, "m").help =
      "Flange dimension qR at which the evolution ends; empty: no limit.";
  }
} // namespace RollingContact
