#ifndef rolling_contact_results_rough_state_h
#define rolling_contact_results_rough_state_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Where a file gives heights, the columns of the waves that the elements
   * resolve, which the area of contact and the peak pressure belong to.
   */
  template <int dim>
  void set_roughness_columns(const SteadyState<dim> &steady,
                             ResultsTable           &table);

  /**
   * Where a file gives heights, tell area of contact A and peak pressure of a
   * state with their cut-off wavelength, as shorter waves would make the one
   * smaller and the other higher, and in 3D A E* slope / N; the slope is the
   * root mean square of the gradient. Of a map warn where the peak pressure is
   * above 3 k, k = Wear/Shear yield stress: what is elastic here would yield.
   */
  template <int dim>
  void tell_rough_state(const PairSpec         &scene,
                        const SteadyState<dim> &steady,
                        RunContext             &context);

  /**
   * Where surfaces pass, warn of steps in time that roll more than an element.
   * @p rolled in a step, m.
   */
  template <int dim>
  void warn_of_long_steps(const PairSpec         &scene,
                          const SteadyState<dim> &steady,
                          const double            rolled,
                          RunContext             &context);
} // namespace RollingContact

#endif
