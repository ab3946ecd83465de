#include <rolling_contact/analyses/limit_cycle_parameters.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    const std::vector<NamedValue<SweepDirection>> sweep_directions{
      {"up", SweepDirection::up},
      {"down", SweepDirection::down},
      {"both", SweepDirection::both}};
  }

  void LimitCycleParameters::declare(Entries &entries)
  {
    entries.section("Limit cycle").read_by_analyses("limit cycle");
    entries.add("Starts", starts, "Hz").help =
      "Vibrations in which runs start, each with Time/Excite velocity: `all` "
      "that grow, or frequencies near theirs, " +
      std::string(number_list_form) +
      ". With an axis they are the vibrations at the first value where any "
      "grows.";
    entries.add("Axis", axis)
      .one_of("none|Contact/Friction coefficient|Stability/Added damping")
      .help =
      "Entry along which each cycle is followed. Every value starts from the "
      "cycle at the value before, about its own steady state. `none`: the "
      "scene as it is.";
    entries.add("Values", values, "1").help = "Values of `Axis`, " +
                                              std::string(number_list_form) +
                                              ", in the unit of that entry.";
    entries.choice("Direction", direction, sweep_directions).help =
      "Order of the values: `up`, `down`, or `both`, which is up and then "
      "down again and shows hysteresis.";
  }

  std::vector<double> LimitCycleParameters::start_frequencies() const
  {
    if (starts_from_all())
      return {};
    const auto frequencies = number_list("Limit cycle/Starts", starts);
    for (const double frequency : frequencies)
      if (!(frequency > 0.))
        throw InputError("Limit cycle/Starts = " + starts +
                         ": frequencies are above 0 Hz; give those near which "
                         "vibrations grow, or all.");
    return frequencies;
  }

  std::string LimitCycleParameters::axis_entry() const
  {
    return axis == "none" ? "" : axis;
  }

  std::vector<double> LimitCycleParameters::axis_values() const
  {
    if (axis_entry().empty())
      return {};
    auto numbers = number_list("Limit cycle/Values", values);
    std::sort(numbers.begin(), numbers.end());
    for (double &number : numbers) // without the rounding of a range
      number = number_of(text_of(number)).value_or(number);
    if (std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end())
      throw InputError("Limit cycle/Values = " + values +
                       ": a value is there twice; give each once.");
    const bool friction = axis == "Contact/Friction coefficient";
    if (numbers.front() < 0. || (friction && numbers.front() == 0.))
      throw InputError("Limit cycle/Values = " + values + ": " + axis + " is " +
                       (friction ? "above" : "at least") +
                       " 0 where cycles are looked for.");
    return numbers;
  }

  void LimitCycleParameters::check() const
  {
    start_frequencies();
    if (axis_entry().empty() != values.empty())
      throw InputError("Limit cycle/Axis = " + axis + ", Values = " + values +
                       ": one needs the other; give an entry and its values, "
                       "or none and nothing.");
    axis_values();
  }
} // namespace RollingContact
