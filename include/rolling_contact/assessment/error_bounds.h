#ifndef rolling_contact_assessment_error_bounds_h
#define rolling_contact_assessment_error_bounds_h

#include <rolling_contact/state/steady_state.h>

#include <optional>
#include <string>

namespace RollingContact
{
  /**
   * How far a state may be off from that of an infinitely fine mesh of the same
   * bodies, and from what that is concluded. Bounds c / n^p measured by
   * tests/campaigns/error_bounds, n the elements across the patch in the
   * direction of rolling, with what adds to them: thin bodies, materials that
   * differ, surfaces with waves, the growth of the mesh, the residual of the
   * solver, edges of the patch that did not settle. A bound that is not known
   * is empty. The time step of a transient run is not in them.
   */
  struct ErrorBounds
  {
    std::optional<double> force;        ///< over mu N
    std::optional<double> moment;       ///< 3D: over mu N a
    std::optional<double> max_pressure; ///< over the peak pressure
    std::string           text;         ///< what that of the force is made of
  };

  template <int dim>
  ErrorBounds
  error_bounds(const SceneParameters &scene, const SteadyState<dim> &steady);
} // namespace RollingContact

#endif
