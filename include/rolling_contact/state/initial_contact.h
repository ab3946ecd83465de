#ifndef rolling_contact_state_initial_contact_h
#define rolling_contact_state_initial_contact_h

#include <rolling_contact/linear_algebra/complex_matrix.h>
#include <rolling_contact/pair/pair_integrator.h>
#include <rolling_contact/state/patch_friction.h>
#include <rolling_contact/state/steady_state.h>

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
    /** Of the vibrations about it, where they are asked for and known. Units:
     * 1/s. */
    ComplexVector eigenvalues;
  };

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
