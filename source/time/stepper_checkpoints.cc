#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/time/contact_stepper.h>

namespace RollingContact
{
  template <int dim>
  void ContactStepper<dim>::save(Checkpoint &checkpoint) const
  {
    checkpoint.motion = motion->save();
    checkpoint.slip   = slip;
    checkpoint.state  = contact.state;
    if (patch_friction)
      checkpoint.patch_friction = patch_friction->memory();
    LastStep &last = checkpoint.last_step;
    last           = {!contact.restored,
                      time_step,
                      contact.problem.operators.time_scaling().rate,
                      contact.problem.loads,
                      contact.solver};
    last.solver.history.clear();
  }

  template <int dim>
  void ContactStepper<dim>::restore(const Checkpoint &checkpoint)
  {
    const ContactProblem &problem = contact.problem;
    const std::size_t     n       = checkpoint.state.pressure.size();
    if (n != problem.n_nodes() ||
        checkpoint.state.traction.values().size() != problem.n_tangential() * n)
      throw InputError("Cannot resume: the checkpoint has " +
                       std::to_string(n) + " contact nodes, the scene " +
                       std::to_string(problem.n_nodes()) +
                       ". Start the run without --resume.");
    const LastStep &last = checkpoint.last_step;
    const bool      any  = checkpoint.progress.step > 0;
    restore_state(checkpoint, any && last.is_known);
    contact.problem.loads.creepages = last.loads.creepages;
    if (!any)
      return;
    set_time_step(last.length);
    set_drive(checkpoint.progress.time - last.length, last.length);
    contact.solver.converged = true;
    contact.restored         = !last.is_known;
    if (last.is_known)
      {
        contact.solver                                  = last.solver;
        static_cast<StepLoads &>(contact.problem.loads) = last.loads;
        contact.problem.operators.set_time_scaling(
          {motion->displacement_factor(), last.rate});
      }
    contact.result = resultants(contact.problem, contact.state);
  }

  template <int dim>
  void ContactStepper<dim>::restore_state(const Checkpoint &checkpoint,
                                          const bool        slip_is_known)
  {
    contact.state = checkpoint.state;
    if (!slip_is_known) // before the next step
      {
        contact.state.edge_law       = true;
        contact.state.holds_friction = !contact.state.friction.empty();
      }
    motion->restore(checkpoint.motion, contact.problem, contact.state);
    watched_position = motion->watched_displacement();
    slip             = checkpoint.slip;
    if (patch_friction)
      {
        patch_friction->set_memory(checkpoint.patch_friction);
        contact.problem.loads.friction = patch_friction->coefficients_now();
      }
    if (scene.inputs->time.hold_approach)
      histories.approach = TimeFunction(contact.state.approach);
  }

  template void ContactStepper<2>::save(Checkpoint &) const;
  template void ContactStepper<2>::restore(const Checkpoint &);
  template void ContactStepper<3>::save(Checkpoint &) const;
  template void ContactStepper<3>::restore(const Checkpoint &);
} // namespace RollingContact
