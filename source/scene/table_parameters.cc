#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/number_list.h>
#include <rolling_contact/scene/entries.h>
#include <rolling_contact/scene/table_parameters.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char form_of_axis[] =
      "give it as Section/Entry = numbers separated by commas, or Section/Entry "
      "= first : last : number of points.";

    std::string name_of_axis(const std::size_t k)
    {
      return "Axis " + std::to_string(k + 1);
    }

    /**
     * Without the rounding of a range: 15 digits, and 0 for what is nothing to
     * the largest value.
     */
    void tidy(std::vector<double> &values)
    {
      double largest = 0.;
      for (const double value : values)
        largest = std::max(largest, std::abs(value));
      for (double &value : values)
        value = std::abs(value) < 1e-14 * largest
                  ? 0.
                  : number_of(text_of(value)).value_or(value);
    }

    TableAxis axis_of(const std::string &name, const std::string &text)
    {
      const std::size_t equals = text.find('=');
      TableAxis         axis{name, trimmed(text.substr(0, equals)), {}};
      if (equals == std::string::npos || axis.entry.empty())
        throw InputError(name + " = " + text + ": " + form_of_axis);
      axis.values = number_list(name + " = " + axis.entry,
                                trimmed(text.substr(equals + 1)));
      tidy(axis.values);
      std::sort(axis.values.begin(), axis.values.end());
      const auto twice =
        std::adjacent_find(axis.values.begin(), axis.values.end());
      if (twice != axis.values.end())
        throw InputError(name + " = " + text + ": " + text_of(*twice) +
                         " is there twice; give each value once.");
      return axis;
    }
  } // namespace

  void TableParameters::declare(Entries &entries)
  {
    entries.section("Table").read_by_analyses("table or stability map");
    for (std::size_t k = 0; k < max_axes; ++k)
      entries.add(name_of_axis(k), axis_texts[k]).help =
        k == 0
          ? "One axis of a full grid of states: Section/Entry = its values, "
            "such as Contact/Creepage x = -0.01 : 0.01 : 21. Values are " +
              std::string(number_list_form) +
              ", in the entry's unit. The entry may be any one with numbers "
              "of sections Wheel, Rail, Contact, Mesh and Profiles; the axis "
              "replaces its value in the scene. Entries of section Contact "
              "keep the bodies, as do places on profiles; all others make new "
              "bodies. Empty for none."
          : std::string("As `Axis 1`.");
    entries.add("File of rows", file_of_rows).help =
      "CSV file in place of axes, relative to the folder of the .prm file. "
      "Its first line names entries as Section/Entry; each other line is a "
      "state. Columns are separated by commas, semicolons or tabs.";
    entries.add("Part", part_text).help =
      "Part of the states that this run solves, as number/of, such as 3/16. "
      "Other runs of the same scene, on any machines, solve the other parts. "
      "Each run has a folder of its own. Empty for all states.";
    entries.add("Join", join).help =
      "Folders of the runs of all parts, separated by commas, with * and ? "
      "for several, such as output/part_*. Their states become one table, and "
      "nothing is solved.";
    entries.add("Threads", threads, "1")
      .resumed_if(in_all_scenes)
      .between(0, 1024)
      .help = "Number of threads that solve states; 0: as many as there are "
              "processors. Results do not depend on it.";
  }

  std::vector<TableAxis> TableParameters::axes() const
  {
    std::vector<TableAxis> axes;
    for (std::size_t k = 0; k < max_axes; ++k)
      {
        const std::string name = "Table/" + name_of_axis(k);
        if (axis_texts[k].empty())
          continue;
        axes.push_back(axis_of(name, axis_texts[k]));
        for (std::size_t other = 0; other + 1 < axes.size(); ++other)
          if (axes[other].entry == axes.back().entry)
            throw InputError(name + " = " + axis_texts[k] + ": " +
                             axes[other].name +
                             " is this entry already; give each entry one "
                             "axis.");
      }
    return axes;
  }

  TablePart TableParameters::part() const
  {
    if (part_text.empty())
      return {};
    if (!join.empty())
      throw InputError("Table/Part = " + part_text +
                       " and Table/Join = " + join +
                       ": a run solves a part or joins parts; leave one of "
                       "them empty.");
    const std::size_t slash  = part_text.find('/');
    const auto        number = number_of(trimmed(part_text.substr(0, slash))),
               of            = slash == std::string::npos
                                 ? std::nullopt
                                 : number_of(trimmed(part_text.substr(slash + 1)));
    const double most        = 1e5;
    if (!number || !of || *number != std::floor(*number) ||
        *of != std::floor(*of) || !(*number >= 1. && *number <= *of) ||
        !(*of <= most))
      throw InputError("Table/Part = " + part_text +
                       ": give the number of the part and how many there are, "
                       "as 3/16, at most 100000.");
    return {static_cast<std::size_t>(*number), static_cast<std::size_t>(*of)};
  }

  void TableParameters::check() const
  {
    part();
    const bool has_axes = !axes().empty();
    if (has_axes && !file_of_rows.empty())
      throw InputError("Table/File of rows = " + file_of_rows + " and " +
                       axes()[0].name +
                       ": a table has axes or rows; leave one of them empty.");
    if (!has_axes && file_of_rows.empty())
      throw InputError("Table/Axis 1 and Table/File of rows are both empty: "
                       "for an axis, " +
                       std::string(form_of_axis));
  }
} // namespace RollingContact
