#ifndef rolling_contact_report_interface_fields_h
#define rolling_contact_report_interface_fields_h

#include <rolling_contact/contact/contact_problem.h>
#include <rolling_contact/interface/trace.h>
#include <rolling_contact/run/run_folder.h>
#include <rolling_contact/state/steady_state.h>

#include <array>
#include <functional>
#include <string>

namespace RollingContact
{
  /** Place (x, y, z) of a point of the interface with these coordinates. */
  using SurfacePlace =
    std::function<std::array<double, 3>(const std::array<double, 2> &)>;

  /**
   * Writes a VTU of the contact surface at its @p place:
   * traction and slip of the wheel, their sizes and bounds, pressure, both as
   * RecoveredTractions too, gap, nodal area and NodeState; zero traction and
   * slip without friction; where it falls the friction coefficient and the
   * sliding speed. Slip, gap and sliding speed are NaN unless @p step_is_known:
   * they need what a step in time does without reactions. Units: Pa, m, m^2,
   * m/s. Throws InputError if the file cannot be written. Collective: the root
   * writes.
   */
  template <int dim>
  void
  write_interface_fields(const Trace          &trace,
                         const ContactProblem &problem,
                         const ContactState   &state,
                         const bool            step_is_known,
                         const SurfacePlace   &place,
                         RunFolder            &folder,
                         const std::string    &file_name);

  /**
   * Writes the interface of a state as @p file, a VTU. Throws InputError if it
   * cannot be written. Collective.
   */
  template <int dim>
  void
  write_interface(const SceneParameters  &scene,
                  const SteadyState<dim> &steady,
                  RunFolder              &folder,
                  const std::string      &file);
} // namespace RollingContact

#endif
