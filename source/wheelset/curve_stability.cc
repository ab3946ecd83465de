#include <rolling_contact/analyses/stability.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/tables/stability_map.h>
#include <rolling_contact/tables/table_rows.h>
#include <rolling_contact/wheelset/curve_stability.h>
#include <rolling_contact/wheelset/found_place.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    /// m, of a straight track among curves
    const double straight = 1e9;

    /** The entries that place a wheel, and their values in its scene. */
    std::vector<std::pair<std::string, double>>
    placing_entries(const Situation &placed)
    {
      const ProfileParameters &profiles = placed.profiles;
      return {{"Profiles/Lateral shift", profiles.shift},
              {"Profiles/Yaw", profiles.yaw},
              {"Profiles/Roll", profiles.roll.value()},
              {"Profiles/Pitch rate", profiles.pitch_rate.value()},
              {"Profiles/Curve radius",
               profiles.curve_radius.value_or(straight)},
              {"Contact/Vertical load", placed.contact.vertical_load.value()}};
    }

    /** Whether where a wheelset runs depends on an entry. */
    bool moves_wheelset(const std::string &entry)
    {
      const auto is_in = [&](const std::string &section) {
        return entry.compare(0, section.size() + 1, section + '/') == 0;
      };
      const auto ends_with = [&](const std::string &name) {
        return entry.size() > name.size() &&
               entry.compare(entry.size() - name.size(), name.size(), name) ==
                 0;
      };
      return is_in("Wheelset") || is_in("Profiles") || is_in("Contact") ||
             entry == "Wheel/Radius" || ends_with("/Young modulus") ||
             ends_with("/Poisson ratio");
    }

    FoundEquilibrium in_mirror(FoundEquilibrium found)
    {
      found.state = found.state.mirrored();
      found.roll  = -found.roll;
      return found;
    }

    std::vector<unsigned int> wheels_of(const WheelsFound wheels)
    {
      if (wheels == WheelsFound::both)
        return {0, 1};
      return {wheels == WheelsFound::left ? 1u : 0u};
    }

    /**
     * Stability of wheels whose place is found.
     */
    class CurveStability : public Analysis
    {
    public:
      CurveStability(const Situation &scene, RunContext &context)
        : scene(scene)
        , context(context)
        , is_map(scene.inputs->analysis.has_many_states)
        , wheels(scene.inputs->stability.wheels)
        , report(scene, scene.inputs->own<WheelsetParameters>(), context)
      {}

      void run() override
      {
        if (is_map || wheels == WheelsFound::both)
          run_many();
        else
          {
            const FoundEquilibrium &found = equilibrium_of(scene, "");
            const Situation         placed =
              scene_of_wheel(scene, found, wheels_of(wheels)[0]);
            Stability<3>(placed, context).run();
          }
      }

    private:
      /** As far as what moves the wheelset, @p key, was met before. */
      const FoundEquilibrium &equilibrium_of(const Situation   &at,
                                             const std::string &key)
      {
        const auto known = equilibria.find(key);
        if (known != equilibria.end())
          return known->second;
        PhaseTimer::Scope       phase(context.timer, Phase::contact_solve);
        const FoundEquilibrium &found =
          equilibria.emplace(key, equilibrium_on_half_spaces(at)).first->second;
        report.add_place(found);
        if (equilibria.size() == 1)
          report.tell(found);
        return found;
      }

      /** Values of the entries that place a wheel; the left one as one of the
       * right in the mirror where both share bodies. */
      std::vector<std::pair<std::string, double>>
      place_of(const Situation        &at,
               const FoundEquilibrium &found,
               const unsigned int      wheel) const
      {
        const bool is_mirrored = wheels == WheelsFound::both && wheel == 1;
        return placing_entries(is_mirrored
                                 ? scene_of_wheel(at, in_mirror(found), 0)
                                 : scene_of_wheel(at, found, wheel));
      }

      TableStates asked_states() const
      {
        if (is_map)
          return table_states(scene.inputs->table, scene.inputs->prm_folder);
        TableStates one;
        one.values.emplace_back();
        return one;
      }

      /** The states asked for, of each wheel, with where that is. */
      TableStates placed_states()
      {
        TableStates       states = asked_states();
        const TableStates asked  = states;
        states.values.clear();
        for (auto &[column, texts] : states.titles)
          texts.clear();
        std::vector<std::string> sides;
        for (const unsigned int wheel : wheels_of(wheels))
          {
            SceneEntries entries(scene);
            for (std::size_t state = 0; state < asked.values.size(); ++state)
              {
                std::string         key;
                std::vector<double> values = asked.values[state];
                for (std::size_t d = 0; d < asked.entries.size(); ++d)
                  {
                    const std::string text = exact_text(values[d]);
                    entries.set(asked.entries[d], text);
                    if (moves_wheelset(asked.entries[d]))
                      key += asked.entries[d] + '=' + text + ' ';
                  }
                const Situation &at = entries.situation();
                for (const auto &[entry, value] :
                     place_of(at, equilibrium_of(at, key), wheel))
                  {
                    values.push_back(value);
                    if (states.values.empty())
                      {
                        states.entries.push_back(entry);
                        states.places.push_back("");
                        ++states.n_found;
                      }
                  }
                states.values.push_back(values);
                for (std::size_t k = 0; k < states.titles.size(); ++k)
                  states.titles[k].second.push_back(
                    asked.titles[k].second[state]);
                sides.push_back(wheel == 1 ? "left" : "right");
              }
          }
        states.titles.emplace_back("wheel", sides);
        return states;
      }

      void run_many()
      {
        const TableStates  states = placed_states();
        const unsigned int wheel  = wheels == WheelsFound::left ? 1 : 0;
        const Situation    placed =
          scene_of_wheel(scene, equilibria.begin()->second, wheel);
        StabilityMap<3>(placed, states, context).run();
        context.log.message(context.results.screen_table({"name",
                                                          "wheel",
                                                          "n_unstable",
                                                          "largest_growth_1/s",
                                                          "fastest_Hz",
                                                          "fastest_mode"}));
        if (!is_map)
          list_vibrations(states);
      }

      /** stability.csv of both wheels. */
      void list_vibrations(const TableStates &states)
      {
        ResultsTable        table(context.folder, "stability.csv");
        const ResultsTable &results = context.results;
        for (std::size_t row = 0; row < results.n_rows(); ++row)
          if (const auto *listed =
                results.value<std::vector<ListedVibration>>(row, "vibrations"))
            for (const ListedVibration &vibration : *listed)
              {
                table.set(
                  "wheel",
                  states.titles.back().second[state_of_row(results, row)]);
                table.set("frequency_Hz", vibration.frequency);
                table.set("growth_1/s", vibration.growth);
                table.set("damping_ratio",
                          -vibration.growth /
                            std::hypot(vibration.growth,
                                       2 * pi * vibration.frequency));
                table.set("unstable", vibration.growth > 0.);
                table.set("wheel_mode_name", vibration.mode);
                table.end_row();
              }
        table.flush();
      }

      const Situation                        &scene;
      RunContext                             &context;
      const bool                              is_map;
      const WheelsFound                       wheels;
      WheelsetReport                          report;
      std::map<std::string, FoundEquilibrium> equilibria;
    };

    template <template <int> class Kind>
    std::unique_ptr<Analysis> make_in_curves(const Situation &scene,
                                             RunContext      &context)
    {
      if (scene.inputs->finds_place())
        return std::make_unique<CurveStability>(scene, context);
      return std::make_unique<Kind<3>>(scene, context);
    }

    AnalysisKind in_curves(AnalysisKind kind, const AnalysisKind::Maker in_3d)
    {
      kind.in_3d             = in_3d;
      kind.takes_found_place = true;
      for (const auto rule : rules_of_disturbed_wheels())
        kind.rules.push_back(rule);
      return kind;
    }
  } // namespace

  AnalysisKind stability_in_curves_kind()
  {
    return in_curves(stability_kind(), &make_in_curves<Stability>);
  }

  AnalysisKind stability_map_in_curves_kind()
  {
    return in_curves(stability_map_kind(), &make_in_curves<StabilityMap>);
  }
} // namespace RollingContact
