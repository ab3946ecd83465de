#ifndef rolling_contact_report_interface_fields_h
#define rolling_contact_report_interface_fields_h

#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/state/steady_state.h>

#include <string>

namespace RollingContact
{
  /**
   * Writes a VTU of the contact surface: traction and slip of the wheel, their
   * sizes and bounds, pressure, both as RecoveredTractions too, gap, nodal area
   * and NodeState; zero traction and slip without friction; where it falls the
   * friction coefficient and the sliding speed; where the speed is given the
   * flash_temperature() of a steady state. Slip, gap and sliding speed are NaN
   * where a restored state does not know what its step does without reactions.
   * Units: Pa, m, m^2, m/s, K. Throws InputError if the file cannot be written.
   * Collective: the root writes.
   */
  template <int dim>
  void
  write_interface(const SceneParameters  &scene,
                  const SteadyState<dim> &steady,
                  RunFolder              &folder,
                  const std::string      &file);
} // namespace RollingContact

#endif
