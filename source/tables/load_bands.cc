#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/tables/load_bands.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

namespace RollingContact
{
  namespace
  {
    /**
     * A load and the place where profiles touch.
     */
    using Touch = std::tuple<double, double, double, std::string>;

    Touch touch_of(const ContactParameters &contact, const std::string &place)
    {
      return {contact.vertical_load ? 0. : contact.normal_load.value_or(0.),
              contact.vertical_load.value_or(0.),
              contact.approach.value_or(0.),
              place};
    }

    /**
     * A state, where profiles touch, and its mesh if it had one of its own.
     */
    struct StateOfGroup
    {
      std::size_t       state;
      std::string       place;
      const WantedMesh *wanted;
    };

    using States = std::vector<StateOfGroup>;

    /**
     * The states of a group; @p known keeps their meshes.
     */
    States states_of(const TablePlan             &plan,
                     const TableGroup            &group,
                     SceneEntries                &entries,
                     std::map<Touch, WantedMesh> &known)
    {
      States states;
      for (const std::size_t state : group.states)
        {
          plan.set(state, entries);
          try
            {
              const Situation  &scene = entries.situation();
              const std::string place = entries.place_key();
              const Touch       touch = touch_of(scene.contact, place);
              if (known.count(touch) == 0)
                known[touch] = wanted_mesh(scene);
              states.push_back({state, place, &known[touch]});
            }
          catch (const InputError &error)
            {
              throw InputError("The state of the table with " +
                               plan.name(state) + ": " + error.what());
            }
        }
      return states;
    }

    /**
     * The states in bands of sizes from large to small, each down to a share @p
     * smallest of its largest; in a band they are in the order that they had.
     */
    std::vector<States>
    cut(const States                                    &states,
        const double                                     smallest,
        const std::function<double(const WantedMesh &)> &size_of)
    {
      std::vector<double> descending;
      for (const StateOfGroup &state : states)
        descending.push_back(size_of(*state.wanted));
      std::sort(descending.rbegin(), descending.rend());
      std::vector<double> largest;
      for (const double size : descending)
        if (largest.empty() || size < smallest * largest.back() ||
            (size == 0. && largest.back() > 0.))
          largest.push_back(size);
      std::vector<States> bands(largest.size());
      for (const StateOfGroup &state : states)
        {
          std::size_t band = largest.size() - 1;
          while (size_of(*state.wanted) > largest[band])
            --band;
          bands[band].push_back(state);
        }
      return bands;
    }

    /**
     * One band of all these states.
     */
    LoadBand band_of(const std::size_t group, const States &states)
    {
      const StateOfGroup &largest =
        *std::max_element(states.begin(),
                          states.end(),
                          [](const auto &one, const auto &other) {
                            return one.wanted->patch.half_width_x <
                                   other.wanted->patch.half_width_x;
                          });
      const PatchEstimate  &patch = largest.wanted->patch;
      std::array<double, 2> size  = largest.wanted->element_size;
      LoadBand              band;
      band.group        = group;
      band.largest      = largest.state;
      band.largest_size = band.smallest_size = patch.half_width_x;
      for (const StateOfGroup &state : states)
        {
          const WantedMesh &wanted = *state.wanted;
          band.states.push_back(state.state);
          band.smallest_size =
            std::min(band.smallest_size, wanted.patch.half_width_x);
          for (unsigned int d = 0; d < 2; ++d)
            size[d] = std::min(size[d], wanted.element_size[d]);
          if (state.place != largest.place)
            band.other_patches.insert(band.other_patches.end(),
                                      wanted.patch.boxes.begin(),
                                      wanted.patch.boxes.end());
        }
      if (band.touches())
        band.n_elements = {
          {2 * patch.half_width_x / size[0], 2 * patch.half_width_y / size[1]}};
      return band;
    }
  } // namespace

  Situation LoadBand::scene(const TablePlan &plan, SceneEntries &entries) const
  {
    plan.set(largest, entries);
    Situation scene = entries.situation();
    take_economical_solver(scene);
    const auto number = [](const double n) {
      return static_cast<unsigned int>(std::ceil(n - 1e-9));
    };
    if (touches())
      {
        scene.mesh.elements_across_patch = number(n_elements[0]);
        if (scene.mesh.elements_across_patch_y > 0 || !other_patches.empty())
          scene.mesh.elements_across_patch_y = number(n_elements[1]);
      }
    return scene;
  }

  std::vector<LoadBand> load_bands(const Situation &scene,
                                   const TablePlan &plan,
                                   const double     smallest)
  {
    std::vector<LoadBand> bands;
    SceneEntries          entries(scene);
    for (std::size_t g = 0; g < plan.groups.size(); ++g)
      {
        std::map<Touch, WantedMesh> known;
        const States all = states_of(plan, plan.groups[g], entries, known);
        for (const States &alike_along :
             cut(all, smallest, [](const WantedMesh &wanted) {
               return wanted.element_size[0];
             }))
          for (const States &alike :
               cut(alike_along, smallest, [](const WantedMesh &wanted) {
                 return wanted.element_size[1];
               }))
            bands.push_back(band_of(g, alike));
      }
    return bands;
  }
} // namespace RollingContact
