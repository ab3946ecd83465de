#ifndef rolling_contact_results_interface_fields_h
#define rolling_contact_results_interface_fields_h

#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <string>

namespace RollingContact
{
  /**
   * Writes a VTU of the contact surface with all nodal_quantities() that the
   * state has; vectors are those of the wheel. Values at a hanging corner are
   * interpolated, the NodeState is a master's.
   * Units: Pa, m, m^2, m/s, K. Throws InputError if the file cannot be written.
   * Collective: the root writes.
   */
  template <int dim>
  void write_interface(const PairSpec         &scene,
                       const SteadyState<dim> &steady,
                       RunFolder              &folder,
                       const std::string      &file);
} // namespace RollingContact

#endif
