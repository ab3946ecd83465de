#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/state/contact_stepper.h>

namespace RollingContact
{
  template <int dim>
  void
  ContactStepper<dim>::save(Checkpoint &checkpoint) const
  {
    checkpoint.pressure = contact.state.pressure;
    checkpoint.traction = contact.state.traction.values();
    checkpoint.approach = contact.state.approach;
    checkpoint.scheme   = contact.state.scheme;
    checkpoint.friction = contact.state.friction;
    checkpoint.bodies   = motion->save();
    checkpoint.past     = motion->past();
    checkpoint.slip     = slip;
    if (patch_friction)
      checkpoint.patch_friction = patch_friction->memory();

    const ContactLoads &loads = contact.problem.loads;
    LastStep           &last  = checkpoint.last_step;
    last                      = {!contact.restored,
                                 time_step,
                                 loads.speed,
                                 {loads.creepages.x, loads.creepages.y, loads.creepages.spin},
                                 contact.problem.operators.time_scaling().rate,
                                 loads.gap,
                                 loads.free_slip,
                                 loads.free_displacement,
                                 loads.slip_share,
                                 loads.slip_before,
                                 loads.friction_arriving,
                                 loads.step_path,
                                 contact.state.edge_law,
                                 contact.state.holds_friction,
                                 contact.solver};
    last.solver.history.clear();
  }



  template <int dim>
  void
  ContactStepper<dim>::restore(const Checkpoint &checkpoint)
  {
    const ContactProblem &problem = contact.problem;
    if (checkpoint.pressure.size() != problem.n_nodes() ||
        checkpoint.traction.size() !=
          problem.n_tangential() * problem.n_nodes())
      throw InputError("Cannot resume: the checkpoint has " +
                       std::to_string(checkpoint.pressure.size()) +
                       " contact nodes, the scene " +
                       std::to_string(problem.n_nodes()) +
                       ". Start the run without --resume.");
    restore_state(checkpoint);
    contact.problem.loads.creepages = {checkpoint.last_step.creepages[0],
                                       checkpoint.last_step.creepages[1],
                                       checkpoint.last_step.creepages[2]};
    if (checkpoint.progress.step == 0)
      return;
    const double h = checkpoint.last_step.length;
    set_time_step(h);
    set_drive(checkpoint.progress.time - h, h);
    contact.solver.converged = true;
    contact.restored         = !checkpoint.last_step.is_known;
    if (checkpoint.last_step.is_known)
      restore_last_step(checkpoint.last_step);
    contact.result = resultants(contact.problem, contact.state);
  }



  template <int dim>
  void
  ContactStepper<dim>::restore_last_step(const LastStep &step)
  {
    contact.state.edge_law       = step.edge_law;
    contact.state.holds_friction = step.holds_friction;
    contact.solver               = step.solver;
    ContactLoads &loads          = contact.problem.loads;
    loads.gap                    = step.gap;
    if (contact.problem.n_tangential() == 0)
      return;
    loads.speed             = step.speed;
    loads.free_slip         = step.free_slip;
    loads.free_displacement = step.free_displacement;
    loads.slip_share        = step.slip_share;
    loads.slip_before       = step.slip_before;
    loads.friction_arriving = step.friction_arriving;
    loads.step_path         = step.step_path;
    contact.problem.operators.set_time_scaling(
      {motion->displacement_factor(), step.rate});
  }



  template <int dim>
  void
  ContactStepper<dim>::restore_state(const Checkpoint &checkpoint)
  {
    // its slip is not known before the next step
    const bool edge_law = true, holds_friction = !checkpoint.friction.empty();
    contact.state = {checkpoint.pressure,
                     NodalField(checkpoint.pressure.size(),
                                checkpoint.traction),
                     checkpoint.approach,
                     checkpoint.scheme,
                     edge_law,
                     checkpoint.friction,
                     holds_friction};
    motion->restore(checkpoint.bodies, contact.problem, contact.state);
    motion->set_past(checkpoint.past);
    watched_position = motion->watched_displacement();
    slip             = checkpoint.slip;
    if (patch_friction)
      {
        patch_friction->set_memory(checkpoint.patch_friction);
        contact.problem.loads.friction = patch_friction->coefficients_now();
      }
    if (scene.time.hold_approach)
      histories.approach = TimeFunction(checkpoint.approach);
  }



  template void
  ContactStepper<2>::save(Checkpoint &) const;
  template void
  ContactStepper<2>::restore(const Checkpoint &);
  template void
  ContactStepper<3>::save(Checkpoint &) const;
  template void
  ContactStepper<3>::restore(const Checkpoint &);
} // namespace RollingContact
