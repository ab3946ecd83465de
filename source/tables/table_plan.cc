#include <fmt/format.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/input/rows_file.h>
#include <rolling_contact/scene/known_entries.h>
#include <rolling_contact/tables/table_plan.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace RollingContact
{
  namespace
  {
    const double most_states = 1e6;

    TableStates states_of_rows(const std::filesystem::path &file)
    {
      const std::string entry = "Table/File of rows";
      NamedRows         rows  = read_rows(entry, file);
      if (double(rows.rows.size()) > most_states)
        throw InputError(entry + " = " + file.string() + ": " +
                         std::to_string(rows.rows.size()) +
                         " states, a million is most; take several tables.");
      TableStates states;
      states.entries = rows.names;
      states.places.assign(rows.names.size(),
                           entry + " = " + file.string() + ": ");
      states.values = std::move(rows.rows);
      if (!rows.titles.empty())
        states.titles.emplace_back("name", std::move(rows.titles));
      return states;
    }

    TableStates states_of_axes(const std::vector<TableAxis> &axes)
    {
      TableStates states;
      states.axes     = axes;
      double n_states = 1.;
      for (const TableAxis &axis : axes)
        {
          states.entries.push_back(axis.entry);
          states.places.push_back(axis.name + ": ");
          n_states *= axis.values.size();
        }
      if (n_states > most_states)
        throw InputError(axes[0].name + " and others: a grid of " +
                         text_of(n_states) +
                         " states, a million is most; take fewer points or "
                         "several tables.");
      for (std::size_t k = 0; k < n_states; ++k)
        {
          std::vector<double> values(axes.size());
          std::size_t         rest = k;
          for (std::size_t d = axes.size(); d-- > 0;)
            {
              values[d] = axes[d].values[rest % axes[d].values.size()];
              rest /= axes[d].values.size();
            }
          states.values.push_back(values);
        }
      return states;
    }

    /**
     * The entries from the one whose steps cost most: new bodies, another
     * patch, then the rest in their order.
     */
    std::vector<std::size_t>
    entries_by_cost(const std::vector<std::string> &entries)
    {
      std::vector<std::size_t> order(entries.size());
      std::iota(order.begin(), order.end(), 0);
      const auto cost = [&](const std::size_t k) {
        return renewed_by(entries[k]);
      };
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const std::size_t a, const std::size_t b) {
                         return cost(a) < cost(b);
                       });
      return order;
    }

    /**
     * The states sorted by their values, entries that cost most first, each
     * entry up and down in turn, so that neighbours differ by one step.
     */
    std::vector<std::size_t> order_of_states(const TableStates &states)
    {
      const auto entries = entries_by_cost(states.entries);
      std::vector<std::vector<double>> levels(entries.size());
      for (std::size_t d = 0; d < entries.size(); ++d)
        {
          std::set<double> values;
          for (const auto &state : states.values)
            values.insert(state[entries[d]]);
          levels[d].assign(values.begin(), values.end());
        }
      // reflected: a digit counts down where the sum of those before is odd
      std::vector<std::vector<std::size_t>> keys(states.values.size());
      for (std::size_t k = 0; k < keys.size(); ++k)
        {
          std::size_t sum = 0;
          for (std::size_t d = 0; d < entries.size(); ++d)
            {
              const std::size_t at =
                std::lower_bound(levels[d].begin(),
                                 levels[d].end(),
                                 states.values[k][entries[d]]) -
                levels[d].begin();
              keys[k].push_back(sum % 2 == 0 ? at : levels[d].size() - 1 - at);
              sum += at;
            }
        }
      std::vector<std::size_t> order(keys.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(),
                       order.end(),
                       [&](const std::size_t a, const std::size_t b) {
                         return keys[a] < keys[b];
                       });
      return order;
    }

    void check_entries(const TableStates &states, const SceneEntries &entries)
    {
      for (std::size_t d = 0; d < states.entries.size(); ++d)
        {
          entries.check_variable(states.entries[d], states.places[d]);
          std::set<double> values;
          for (const auto &state : states.values)
            values.insert(state[d]);
          for (const double value : values)
            entries.check(states.entries[d],
                          exact_text(value),
                          states.places[d]);
        }
    }
  } // namespace

  std::string exact_text(const double value)
  {
    return fmt::format("{}", value);
  }

  std::string TableStates::name(const std::size_t state) const
  {
    std::string name;
    const auto  add = [&](const std::string &what, const std::string &value) {
      name += (name.empty() ? "" : ", ") + what + " = " + value;
    };
    for (const auto &[column, texts] : titles)
      add(column, texts[state]);
    if (titles.empty() || titles.front().first != "name")
      for (std::size_t d = 0; d + n_found < entries.size(); ++d)
        add(entries[d], exact_text(values[state][d]));
    return name;
  }

  TableStates table_states(const TableParameters       &table,
                           const std::filesystem::path &folder)
  {
    table.check();
    return table.file_of_rows.empty()
             ? states_of_axes(table.axes())
             : states_of_rows(folder / table.file_of_rows);
  }

  void TablePlan::set(const std::size_t state,
                      SceneEntries     &scene_entries) const
  {
    for (std::size_t d = 0; d < entries.size(); ++d)
      scene_entries.set(entries[d], exact_text(values[state][d]));
  }

  TablePlan plan_table(const Situation &scene, const TableStates &states)
  {
    TablePlan plan;
    static_cast<TableStates &>(plan) = states;
    SceneEntries entries(scene);
    check_entries(plan, entries);
    for (const std::string &entry : plan.entries)
      plan.units.push_back(entries.unit(entry));
    std::map<std::string, std::size_t> groups;
    for (const std::size_t state : order_of_states(plan))
      {
        plan.set(state, entries);
        try
          {
            entries.check_scene();
          }
        catch (const InputError &error)
          {
            throw InputError("The state of the table with " + plan.name(state) +
                             ": " + error.what());
          }
        const std::string key      = entries.bodies_key();
        const auto [group, is_new] = groups.emplace(key, plan.groups.size());
        if (is_new)
          plan.groups.push_back({key, {}});
        plan.groups[group->second].states.push_back(state);
      }
    return plan;
  }

  TablePlan plan_table(const Situation &scene)
  {
    return plan_table(scene,
                      table_states(scene.inputs->table,
                                   scene.inputs->prm_folder));
  }
} // namespace RollingContact
