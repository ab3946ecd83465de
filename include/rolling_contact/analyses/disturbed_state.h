#ifndef rolling_contact_analyses_disturbed_state_h
#define rolling_contact_analyses_disturbed_state_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/stability/linear_contact.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * The steady rolling state of a scene that an analysis disturbs, on bodies
   * which keep their factors; its row, its errors and its warnings are told.
   * Split bodies are taken from and added to @p split_bodies, if there are
   * such. Throws InputError without contact, ConvergenceError if it is not
   * found.
   */
  template <int dim>
  SteadyState<dim>
  disturbed_state(const Situation                    &scene,
                  RunContext                         &context,
                  const std::shared_ptr<SplitBodies> &split_bodies = {});

  /** Warns of a stick zone whose leading edge cannot move. */
  void warn_of_fixed_edges(const LinearContact   &contact,
                           const SlipOperatorKind kind,
                           Log                   &log);
} // namespace RollingContact

#endif
