#ifndef rolling_contact_state_initial_contact_h
#define rolling_contact_state_initial_contact_h

#include <rolling_contact/pair/pair_integrator.h>
#include <rolling_contact/state/steady_state.h>

#include <memory>

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
  };

  /**
   * Mesh, matrices and the state that a transient run starts from: no pressure
   * and no traction, or the steady state under what drives at t = 0. With
   * inertia from rest the compliance comes with the first time step. Throws
   * InputError, ConvergenceError.
   */
  template <int dim>
  InitialContact<dim>
  make_initial_contact(const SceneParameters  &scene,
                       const PairDemands      &demands,
                       const DrivingFunctions &histories,
                       RunContext             &context);
} // namespace RollingContact

#endif
