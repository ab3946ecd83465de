#ifndef rolling_contact_assessment_result_error_h
#define rolling_contact_assessment_result_error_h

#include <rolling_contact/run/run_report.h>
#include <rolling_contact/state/steady_state.h>

#include <string>

namespace RollingContact
{
  /**
   * Error of the force to be expected of a mesh, over mu N, and how it is
   * found: a bound c / n^p of what accuracy studies measured, n the elements
   * across the patch, largest over mesh positions, directions and creepages of
   * 0.1 to 0.9 of saturation. Conservative for graded meshes.
   */
  struct ResolutionEstimate
  {
    double      error = 0.;
    std::string text;
  };

  template <int dim>
  ResolutionEstimate
  resolution_estimate(const SceneParameters  &scene,
                      const SteadyState<dim> &steady);

  /**
   * Note in the report how far the state is off. The force against Carter where
   * that holds, else estimated: from the change between levels if there are
   * any, or from the resolution. Without friction, the load against the exact
   * clamped discs if the scene has them. In 3D, and where there is nothing
   * else, the pressure against Hertz. Of several states the largest is kept.
   * Nothing without contact.
   */
  template <int dim>
  void
  note_error(const SceneParameters  &scene,
             const SteadyState<dim> &steady,
             RunReport              &report);

  /**
   * Note in the report how far a transient run is off: the estimate for a
   * steady state on its mesh, as its time step is not estimated; without
   * friction nothing is.
   */
  template <int dim>
  void
  note_error_of_step(const SceneParameters  &scene,
                     const SteadyState<dim> &steady,
                     RunReport              &report);
} // namespace RollingContact

#endif
