#ifndef rolling_contact_analyses_disturbed_state_h
#define rolling_contact_analyses_disturbed_state_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/stability/linear_contact.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/vibration/modal_bodies.h>

#include <memory>

namespace RollingContact
{
  /**
   * The steady rolling state of a scene that an analysis disturbs, on bodies
   * which keep their factors; its row, its errors and its warnings are told.
   * Throws InputError without contact, ConvergenceError if it is not found.
   */
  template <int dim>
  SteadyState<dim> disturbed_state(const Situation &scene, RunContext &context);

  /**
   * Such states at several places of a track: what of the bodies is the same at
   * the next place is made once, split bodies and the modes of bodies.
   */
  template <int dim>
  class DisturbedPlaces
  {
  public:
    DisturbedPlaces();

    /** As disturbed_state(). */
    SteadyState<dim> state_at(const Situation &place, RunContext &context);

    /** The modes of the bodies of a state there, until the next call. */
    const ModalBodies<dim> &modes_of(const SteadyState<dim> &steady,
                                     const Situation        &place,
                                     RunContext             &context);

  private:
    const std::shared_ptr<SplitBodies> split_bodies;
    std::unique_ptr<ModalBodies<dim>>  modes;
  };

  /** Warns of a stick zone whose leading edge cannot move. */
  void warn_of_fixed_edges(const LinearContact   &contact,
                           const SlipOperatorKind kind,
                           Log                   &log);
} // namespace RollingContact

#endif
