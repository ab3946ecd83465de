#ifndef rolling_contact_time_initial_contact_h
#define rolling_contact_time_initial_contact_h

#include <rolling_contact/algebra/dense_matrix.h>
#include <rolling_contact/pair/pair_integrator.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/time/patch_friction.h>
#include <rolling_contact/vibration/modal_bodies.h>

#include <complex>
#include <memory>
#include <optional>

namespace RollingContact
{
  /**
   * The difference that a vibration makes to a state in time of reduced bodies.
   * It is that of a vibration about a steady state, or the difference of a
   * given state from its steady state, with which another run begins. A limit
   * cycle hands the latter on to the next run.
   */
  struct Disturbance
  {
    ReducedState motion;
    PatchMemory  friction;
  };

  /**
   * A contact at t = 0 and the motion of its bodies.
   */
  template <int dim>
  struct InitialContact
  {
    SteadyState<dim>                     contact;
    std::unique_ptr<PairIntegrator<dim>> motion;
    /** Modes of reduced bodies; nullptr for bodies of finite elements. */
    std::shared_ptr<const ModalBodies<dim>> modes;
    /** In place of a law that falls, of a patch or constant; see
     * Situation::friction_response(). */
    std::optional<PatchFriction> friction;
    Disturbance                  undisturbed; ///< the steady state
    /**
     * Eigenvalue of the vibration that the run begins in, see Time/Excite mode.
     * Units: 1/s.
     */
    std::optional<std::complex<double>> excited;
    /**
     * Eigenvalues of the vibrations about the state, where they are asked for
     * and known. Units: 1/s.
     */
    ComplexValues eigenvalues;
  };

  /**
   * Bodies that are meshed, condensed and reduced to their modes once, for runs
   * under other loads, and a steady state on them.
   */
  template <int dim>
  struct ReducedBodies
  {
    SteadyState<dim>                  base; ///< with its compliance
    std::shared_ptr<ModalBodies<dim>> modes;
  };

  /**
   * Mesh, condense, solve the scene's steady state and find the modes; @p
   * demands: what else is asked of the bodies. Throws InputError,
   * ConvergenceError.
   */
  template <int dim>
  ReducedBodies<dim> make_reduced_bodies(const Situation   &scene,
                                         const PairDemands &demands,
                                         RunContext        &context);

  /**
   * The steady state of a scene on @p bodies, from the one they have, at rest
   * or in the vibration of Time/Excite mode as for steps of length @p h (s),
   * and then disturbed. The scene differs from that of the bodies by its loads
   * alone. Throws InputError, ConvergenceError.
   */
  template <int dim>
  InitialContact<dim> make_reduced_contact(const Situation          &scene,
                                           const ReducedBodies<dim> &bodies,
                                           const DrivingFunctions   &histories,
                                           const double              h,
                                           const Disturbance *disturbance,
                                           RunContext        &context);

  /**
   * Mesh, matrices and the state that a transient run starts from: no pressure
   * and no traction, or the steady state under what drives at t = 0. With
   * inertia from rest the compliance comes with the first time step. Bodies by
   * their modes may begin in a vibration, as for steps of length @p h (s).
   * Throws
   * InputError, ConvergenceError.
   */
  template <int dim>
  InitialContact<dim> make_initial_contact(const Situation        &scene,
                                           const PairDemands      &demands,
                                           const DrivingFunctions &histories,
                                           const double            h,
                                           RunContext             &context);
} // namespace RollingContact

#endif
