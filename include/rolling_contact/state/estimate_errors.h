#ifndef rolling_contact_state_estimate_errors_h
#define rolling_contact_state_estimate_errors_h

#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Make the problems on every second node at all positions, which serve all
   * states of one problem, if there are none yet.
   */
  template <int dim>
  void make_halves(const PairSpec &scene, SteadyState<dim> &steady);

  /**
   * The state on every second node with the loads of the whole problem, from
   * its state. None if it was not found.
   */
  std::optional<ContactState> state_of_half(const PairSpec       &scene,
                                            const ContactProblem &whole,
                                            const ContactState   &from,
                                            HalvedProblem        &half);

  /**
   * Find out what a state tells of its errors, for its estimate. It takes 2
   * (2D) or 4 (3D) contact problems with half of the nodes along each
   * direction, and one linear system of such a size; creepages that were found
   * for forces are kept. Nothing of a state that did not converge, does not
   * touch, or moves in time.
   */
  template <int dim>
  void estimate_errors(const PairSpec &scene, SteadyState<dim> &steady);
} // namespace RollingContact

#endif
