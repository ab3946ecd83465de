#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/load_bands.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace RollingContact
{
  namespace
  {
    using Load = std::tuple<double, double, double>;

    Load load_of(const ContactParameters &contact)
    {
      return {contact.vertical_load ? 0. : contact.normal_load.value_or(0.),
              contact.vertical_load.value_or(0.),
              contact.approach.value_or(0.)};
    }

    /**
     * Half-widths of the patches of the states of a group.
     */
    std::vector<double> sizes_of(const TablePlan  &plan,
                                 const TableGroup &group,
                                 SceneEntries     &entries)
    {
      std::map<Load, double> known;
      std::vector<double>    sizes;
      for (const std::size_t state : group.states)
        {
          plan.set(state, entries);
          try
            {
              const Situation &scene = entries.situation();
              const auto [place, is_new] =
                known.emplace(load_of(scene.contact), 0.);
              if (is_new)
                place->second = patch_size(scene);
              sizes.push_back(place->second);
            }
          catch (const InputError &error)
            {
              throw InputError("The state of the table with " +
                               plan.name(state) + ": " + error.what());
            }
        }
      return sizes;
    }

    void take_states(const std::vector<std::size_t> &states,
                     const std::vector<double>      &sizes,
                     LoadBand                       &band)
    {
      bool has_largest = false;
      for (std::size_t k = 0; k < states.size(); ++k)
        {
          if (sizes[k] > band.largest_size || sizes[k] < band.smallest_size)
            continue;
          band.states.push_back(states[k]);
          if (!has_largest && sizes[k] == band.largest_size)
            {
              band.largest = states[k];
              has_largest  = true;
            }
        }
    }
  } // namespace

  Situation LoadBand::scene(const TablePlan &plan, SceneEntries &entries) const
  {
    plan.set(largest, entries);
    Situation scene = entries.situation();
    take_economical_solver(scene);
    const auto more = [&](const unsigned int n) {
      return static_cast<unsigned int>(
        std::ceil(n * largest_size / smallest_size - 1e-9));
    };
    if (touches())
      {
        scene.mesh.elements_across_patch =
          more(scene.mesh.elements_across_patch);
        scene.mesh.elements_across_patch_y =
          more(scene.mesh.elements_across_patch_y);
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
        const std::vector<std::size_t> &states = plan.groups[g].states;
        const std::vector<double>       sizes =
          sizes_of(plan, plan.groups[g], entries);
        std::vector<double> descending = sizes;
        std::sort(descending.rbegin(), descending.rend());
        for (double size : descending)
          {
            const bool is_served =
              !bands.empty() && bands.back().group == g &&
              (size == bands.back().smallest_size ||
               (size > 0. && size >= smallest * bands.back().largest_size));
            if (!is_served)
              {
                bands.emplace_back();
                bands.back().group        = g;
                bands.back().largest_size = size;
              }
            bands.back().smallest_size = size;
          }
        for (LoadBand &band : bands)
          if (band.group == g)
            take_states(states, sizes, band);
      }
    return bands;
  }
} // namespace RollingContact
