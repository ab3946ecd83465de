#ifndef rolling_contact_report_state_fields_h
#define rolling_contact_report_state_fields_h

#include <rolling_contact/run/pvd.h>
#include <rolling_contact/state/steady_state.h>

#include <functional>
#include <string>
#include <vector>

namespace RollingContact
{
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

  /**
   * Writes the elastic bodies of a state, displaced by @p displacement, under
   * the names that @p file_name makes of `wheel` and `rail`; what belongs into
   * a collection at @p time. Throws InputError if a file cannot be written.
   * Collective. Units: s.
   */
  template <int dim>
  std::vector<PvdBlock>
  write_bodies(const SteadyState<dim>               &steady,
               const std::function<BodyField(Side)> &displacement,
               const std::function<std::string(const std::string &)> &file_name,
               const double                                           time,
               RunFolder                                             &folder);
} // namespace RollingContact

#endif
