#ifndef rolling_contact_results_result_error_h
#define rolling_contact_results_result_error_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/run/run_report.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Note in the report how far the state is off: the force by error_bounds(),
   * with its difference to Carter where he holds. Without friction, the load
   * against the exact clamped discs if the scene has them. In 3D, and where
   * there is nothing else, the pressure against Hertz. Of several states the
   * largest is kept. Nothing without contact.
   */
  template <int dim>
  void note_error(const PairSpec         &scene,
                  const SteadyState<dim> &steady,
                  RunReport              &report);

  /**
   * Note in the report how far a transient run is off: the estimate for a
   * steady state on its mesh, as long as its time step is not estimated;
   * without friction nothing is.
   */
  template <int dim>
  void note_error_of_step(const PairSpec         &scene,
                          const SteadyState<dim> &steady,
                          RunReport              &report);

  /**
   * How far what a transient run ends with may be off by the length of its
   * steps.
   */
  struct StepErrors
  {
    double force = 0.; ///< over mu N; 0 without friction
    double load  = 0.; ///< over N
  };

  /**
   * Add to what note_error_of_step() noted what the time step may add: to the
   * error of the force, or of the load without friction, whose mesh stays
   * unknown.
   */
  void add_error_of_step(const StepErrors &of_step, RunReport &report);

  /**
   * Warn of each error in the report that is not known.
   */
  void warn_of_unknown_errors(RunContext &context);
} // namespace RollingContact

#endif
