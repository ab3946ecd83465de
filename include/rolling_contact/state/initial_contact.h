#ifndef rolling_contact_state_initial_contact_h
#define rolling_contact_state_initial_contact_h

#include <rolling_contact/linear_algebra/complex_matrix.h>
#include <rolling_contact/motion/pair_integrator.h>
#include <rolling_contact/state/patch_friction.h>
#include <rolling_contact/state/steady_state.h>
#include <rolling_contact/vibration/modal_bodies.h>
#include <rolling_contact/vibration/reduced_motion.h>

#include <complex>
#include <memory>
#include <optional>

namespace RollingContact
{
  /**
   * A contact at t = 0 and the motion of its bodies.
   */
  template <int dim>
  struct InitialContact
  {
    SteadyState<dim>                     contact;
    std::unique_ptr<PairIntegrator<dim>> motion;
    /** In place of a law that falls, of a patch or constant; see
     * SceneParameters::friction_response(). */
    std::optional<PatchFriction> friction;
    PatchMemory                  friction_of_start; ///< undisturbed
    /** Of the vibration that it begins in, see Time/Excite mode. Units: 1/s. */
    std::optional<std::complex<double>> excited;
    /** Of the vibrations about it, where they are asked for and known. Units:
     * 1/s. */
    ComplexVector eigenvalues;
  };

  /**
   * How a state in time by reduced bodies is off its steady state, to begin
   * another run with: what a limit cycle hands on to the next.
   */
  struct Disturbance
  {
    ReducedState motion;      ///< its differences
    double       share  = 0.; ///< of PatchMemory::share
    double       target = 0.; ///< of PatchMemory::target
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
   * Mesh, condense, solve the scene's steady state and find the modes. Throws
   * InputError, ConvergenceError.
   */
  template <int dim>
  ReducedBodies<dim>
  make_reduced_bodies(const SceneParameters &scene,
                      const StateDemands    &demands,
                      RunContext            &context);

  /**
   * The steady state of a scene on @p bodies, from the one they have, at rest
   * or in the vibration of Time/Excite mode as for steps of length @p h (s),
   * and then disturbed. The scene differs from that of the bodies by its loads
   * alone. Throws InputError, ConvergenceError.
   */
  template <int dim>
  InitialContact<dim>
  make_reduced_contact(const SceneParameters    &scene,
                       const ReducedBodies<dim> &bodies,
                       const DrivingFunctions   &histories,
                       const double              h,
                       const Disturbance        *disturbance,
                       RunContext               &context);

  /**
   * Mesh, matrices and the state that a transient run starts from: no pressure
   * and no traction, or the steady state under what drives at t = 0. With
   * inertia from rest the compliance comes with the first time step. Bodies by
   * their modes may begin in a vibration, as for steps of length @p h (s).
   * Throws
   * InputError, ConvergenceError.
   */
  template <int dim>
  InitialContact<dim>
  make_initial_contact(const SceneParameters  &scene,
                       const PairDemands      &demands,
                       const DrivingFunctions &histories,
                       const double            h,
                       RunContext             &context);
} // namespace RollingContact

#endif
