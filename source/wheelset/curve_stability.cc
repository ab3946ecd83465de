#include <rolling_contact/analyses/stability.h>
#include <rolling_contact/base/constants.h>
#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/tables/stability_map.h>
#include <rolling_contact/tables/table_rows.h>
#include <rolling_contact/wheelset/curve_stability.h>
#include <rolling_contact/wheelset/found_place.h>

#include <cmath>
#include <map>

namespace RollingContact
{
  namespace
  {
    /** Whether where a wheelset on half-spaces runs depends on an entry. */
    bool moves_wheelset(const std::string &path)
    {
      const std::size_t slash   = path.find('/');
      const std::string section = path.substr(0, slash),
                        name    = path.substr(slash + 1);
      return section == "Wheelset" || section == "Profiles" ||
             section == "Contact" || path == "Wheel/Radius" ||
             name == "Young modulus" || name == "Poisson ratio";
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
          return run_many();
        const FoundEquilibrium &found = equilibrium_of(scene, "");
        report.tell(found);
        const Situation placed =
          scene_of_wheel(scene, found, wheels_of(wheels)[0]);
        Stability<3>(placed, context).run();
      }

    private:
      /** One is found for each text @p key of what moves the wheelset. */
      const FoundEquilibrium &equilibrium_of(const Situation   &at,
                                             const std::string &key)
      {
        const auto known = equilibria.find(key);
        if (known != equilibria.end())
          return known->second;
        PhaseTimer::Scope       phase(context.timer, Phase::contact_solve);
        const FoundEquilibrium &found =
          equilibria.emplace(key, equilibrium_on_half_spaces(at)).first->second;
        report.add_row(at, found);
        return found;
      }

      TableStates asked_states() const
      {
        if (is_map)
          return table_states(scene.inputs->table, scene.inputs->prm_folder);
        TableStates one;
        one.values.emplace_back();
        return one;
      }

      /** The equilibrium of a state, whose entries are set. */
      const FoundEquilibrium &equilibrium_of(const TableStates &asked,
                                             const std::size_t  state,
                                             SceneEntries      &entries)
      {
        std::string key;
        for (std::size_t d = 0; d < asked.entries.size(); ++d)
          {
            const std::string &entry = asked.entries[d],
                              text   = exact_text(asked.values[state][d]);
            entries.set(entry, text);
            if (moves_wheelset(entry))
              key += entry + '=' + text + ' ';
          }
        try
          {
            return equilibrium_of(entries.situation(), key);
          }
        catch (const ConvergenceError &error)
          {
            throw ConvergenceError("The state of the table with " +
                                   asked.name(state) + ": " + error.what());
          }
      }

      /** The states asked for, of each wheel, with where that is; the left one
       * as one of the right in the mirror where both share bodies. */
      TableStates placed_states(const TableStates &asked)
      {
        TableStates states = asked;
        states.values.clear();
        for (auto &[column, texts] : states.titles)
          texts.clear();
        states.titles.emplace_back("wheel", std::vector<std::string>());
        SceneEntries entries(scene);
        for (const unsigned int wheel : wheels_of(wheels))
          for (std::size_t state = 0; state < asked.values.size(); ++state)
            {
              const FoundEquilibrium &found =
                equilibrium_of(asked, state, entries);
              const Situation &at = entries.situation();
              const bool       is_mirrored =
                wheels == WheelsFound::both && wheel == 1;
              const auto place = is_mirrored
                                   ? placing_entries(at, in_mirror(found), 0)
                                   : placing_entries(at, found, wheel);
              states.n_found   = place.size();
              states.values.push_back(asked.values[state]);
              for (const auto &[entry, value] : place)
                {
                  states.values.back().push_back(value);
                  if (states.entries.size() < states.values.back().size())
                    {
                      states.entries.push_back(entry);
                      states.places.emplace_back();
                    }
                }
              for (std::size_t k = 0; k < asked.titles.size(); ++k)
                states.titles[k].second.push_back(
                  asked.titles[k].second[state]);
              states.titles.back().second.push_back(wheel == 1 ? "left"
                                                               : "right");
            }
        return states;
      }

      void run_many()
      {
        const TableStates asked = asked_states(), states = placed_states(asked);
        if (equilibria.size() == 1)
          report.tell(equilibria.begin()->second);
        else
          context.report.set_finding("curves",
                                     std::to_string(equilibria.size()) +
                                       " equilibria of the wheelset, "
                                       "wheelset.csv");
        SceneEntries            entries(scene);
        const FoundEquilibrium &first = equilibrium_of(asked, 0, entries);
        const Situation         placed =
          scene_of_wheel(scene, first, wheels == WheelsFound::left ? 1 : 0);
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
