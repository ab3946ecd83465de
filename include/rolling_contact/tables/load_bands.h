#ifndef rolling_contact_tables_load_bands_h
#define rolling_contact_tables_load_bands_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/table_plan.h>

namespace RollingContact
{
  /**
   * States whose patches are so similar in size that one mesh serves them all.
   * The mesh is made for the largest patch, and in all places where profiles
   * touch. It has so many more elements that the smallest patch, too, has as
   * many as the scene asks for.
   */
  struct LoadBand
  {
    std::size_t              group;       ///< of the plan
    std::vector<std::size_t> states;      ///< as in the group
    std::size_t              largest = 0; ///< the state to make the mesh for
    double largest_size = 0., smallest_size = 0.; ///< half-widths of patches, m
    std::array<double, 2> n_elements{};           ///< across the largest patch
    std::vector<ZoneBox>  other_patches;          ///< at other places

    bool touches() const
    {
      return largest_size > 0.;
    }

    /**
     * The scene of the largest patch, with the elements that this takes.
     */
    Situation scene(const TablePlan &plan, SceneEntries &entries) const;
  };

  /**
   * The bands of all groups of a plan, from large to small patches, each with
   * elements down to a share @p smallest of its largest ones. Throws InputError
   * naming the state that no patch can be estimated for.
   */
  std::vector<LoadBand> load_bands(const Situation &scene,
                                   const TablePlan &plan,
                                   const double     smallest);
} // namespace RollingContact

#endif
