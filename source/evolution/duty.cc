#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/evolution/duty.h>
#include <rolling_contact/evolution/evolution_parameters.h>
#include <rolling_contact/input/rows_file.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/tables/table_plan.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    const char share_column[] = "share";

    const double largest_gap = 1e-6; ///< of the sum of shares to 1

    void check_column(const std::string  &entry,
                      const SceneEntries &entries,
                      const std::string  &place)
    {
      const std::string section = entry.substr(0, entry.find('/'));
      if (section != "Wheelset" && section != "Contact")
        throw InputError(place + quotable(entry) +
                         " is no column of a duty; take entries of sections "
                         "Wheelset and Contact, `share` and `name`.");
      if (entry == "Wheelset/Left wheel radius")
        throw InputError(place + entry +
                         " is no column of a duty: all rows wear the same "
                         "wheels; give it in the scene.");
      entries.check_variable(entry, place);
    }

    void check_shares(const NamedRows   &rows,
                      const std::size_t  column,
                      const std::string &place)
    {
      double sum = 0.;
      for (std::size_t k = 0; k < rows.rows.size(); ++k)
        {
          const double share = rows.rows[k][column];
          if (!(share > 0. && share <= 1.))
            throw InputError(place + "row " + std::to_string(k + 1) +
                             ": share = " + text_of(share) +
                             "; give a share of the distance above 0, up to "
                             "1.");
          sum += share;
        }
      if (!(std::abs(sum - 1.) <= largest_gap))
        throw InputError(place + "the shares sum to " + text_of(sum) +
                         "; they are parts of the distance and sum to 1.");
    }
  } // namespace

  std::vector<DutyCase> read_duty(const Situation &scene)
  {
    const std::string &name =
      scene.inputs->own<EvolutionParameters>().file_of_rows;
    std::vector<DutyCase> duty;
    if (name.empty())
      {
        duty.push_back({"the scene", 1., scene});
        return duty;
      }
    const std::string entry = "Evolution/File of rows",
                      place = entry + " = " + name + ": ";
    const NamedRows   rows  = read_rows(entry, scene.inputs->prm_folder / name);
    const std::size_t share =
      std::find(rows.names.begin(), rows.names.end(), share_column) -
      rows.names.begin();
    if (share == rows.names.size())
      throw InputError(place + "no column `share`; give each row its part of "
                               "the distance.");
    check_shares(rows, share, place);
    SceneEntries entries(scene);
    for (const std::string &column : rows.names)
      if (column != share_column)
        check_column(column, entries, place);
    for (std::size_t k = 0; k < rows.rows.size(); ++k)
      {
        const std::string row   = "row " + std::to_string(k + 1);
        const std::string of_it = place + row + ": ";
        for (std::size_t c = 0; c < rows.names.size(); ++c)
          if (c != share)
            {
              const std::string value = exact_text(rows.rows[k][c]);
              entries.check(rows.names[c], value, of_it);
              entries.set(rows.names[c], value);
            }
        try
          {
            entries.check_scene();
            duty.push_back({rows.titles.empty() ? row : rows.titles[k],
                            rows.rows[k][share],
                            entries.situation()});
          }
        catch (const InputError &error)
          {
            throw InputError(of_it + error.what());
          }
      }
    return duty;
  }
} // namespace RollingContact
