#ifndef rolling_contact_results_state_errors_h
#define rolling_contact_results_state_errors_h

#include <rolling_contact/contact/recovered_tractions.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <optional>
#include <vector>

namespace RollingContact
{
  /**
   * RecoveredTractions on the trace of a mesh, Pa: those of the finest stand in
   * where a scene has no closed form.
   */
  struct TractionField
  {
    Trace              trace;
    RecoveredTractions recovered;
  };

  /**
   * How far a state is from Hertz and, in 2D, from Carter and the exact load of
   * clamped discs, all at the computed load. Tractions over mu p0, pressures
   * over p0, with L2 as in Errors2D, in 3D over the area a b. On profiles both
   * are compared with the finest mesh, over the peak pressure of the state
   * and its area over pi.
   */
  struct StateErrors
  {
    std::optional<double> load; ///< relative, where its closed form is known
    std::optional<double> pressure_l2;
    std::optional<double> traction_l2;
    std::optional<double> sawtooth;
    std::optional<double> stick_boundary; ///< elements
  };

  /**
   * Errors of a converged state in contact. Tractions are compared with
   * @p finest where Carter does not hold, on profiles pressures too; nullptr
   * for none.
   */
  template <int dim>
  StateErrors state_errors(const PairSpec         &scene,
                           const SteadyState<dim> &steady,
                           const TractionField    *finest);

  /**
   * Whether Carter's tractions are those of the scene's bodies.
   */
  template <int dim>
  bool follows_carter(const PairSpec &scene, const SteadyState<dim> &steady);
} // namespace RollingContact

#endif
