#ifndef rolling_contact_results_profile_columns_h
#define rolling_contact_results_profile_columns_h

#include <rolling_contact/run/results_table.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Where profiles touch: place and angle of the contact, forces in the axes of
   * the track, and each patch.
   */
  template <int dim>
  void set_profile_columns(const PairSpec         &scene,
                           const SteadyState<dim> &steady,
                           ResultsTable           &table);

  /**
   * The first contact, the patches and the forces in the axes of the track, for
   * the screen.
   */
  template <int dim>
  void note_profiles(const PairSpec         &scene,
                     const SteadyState<dim> &steady,
                     RunReport              &report);
} // namespace RollingContact

#endif
