#include <rolling_contact/program/scene_doubts.h>
#include <rolling_contact/scene/plausibility.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  namespace
  {
    using Sentences = std::vector<std::string>;

    void add_new(const Sentences &more, Sentences &sentences)
    {
      for (const std::string &sentence : more)
        if (std::find(sentences.begin(), sentences.end(), sentence) ==
            sentences.end())
          sentences.push_back(sentence);
    }

    /**
     * The states in which an entry of section Contact, Wheel or Rail is
     * farthest from zero or nearest to it.
     */
    std::set<std::size_t> extreme_states(const TableStates &states)
    {
      static const std::set<std::string> sections{"Contact", "Wheel", "Rail"};
      std::set<std::size_t>              found;
      for (std::size_t d = 0; d < states.entries.size(); ++d)
        {
          const std::string &entry = states.entries[d];
          if (sections.count(entry.substr(0, entry.find('/'))) == 0)
            continue;
          const auto [nearest, farthest] =
            std::minmax_element(states.values.begin(),
                                states.values.end(),
                                [d](const auto &a, const auto &b) {
                                  return std::abs(a[d]) < std::abs(b[d]);
                                });
          found.insert(nearest - states.values.begin());
          found.insert(farthest - states.values.begin());
        }
      return found;
    }

    Sentences implausible(const Situation &scene)
    {
      return implausible_values(*scene.inputs, scene.contact.creepages);
    }

    Sentences doubts_of_states(const Situation &scene, const TablePlan &plan)
    {
      Sentences doubts;
      for (const std::size_t state : extreme_states(plan))
        {
          SceneEntries entries(scene);
          plan.set(state, entries);
          add_new(implausible(entries.situation()), doubts);
        }
      return doubts;
    }
  } // namespace

  std::vector<std::string> doubts_of(const Situation                &scene,
                                     const std::optional<TablePlan> &table,
                                     std::set<std::string>           given)
  {
    Sentences doubts = implausible(scene);
    if (table)
      {
        add_new(doubts_of_states(scene, *table), doubts);
        given.insert(table->entries.begin(), table->entries.end());
      }
    add_new(doubtful_profiles(*scene.inputs), doubts);
    add_new(doubtful_defaults(*scene.inputs, given), doubts);
    add_new(doubtful_bore(scene), doubts);
    return doubts;
  }
} // namespace RollingContact
