#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/number_text.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/scene/shared_rules.h>

#include <algorithm>

namespace RollingContact
{
  namespace
  {
    /** The axle moves as forces of contact differ from those of the start. */
    void check_axle_in_time(const SceneParameters &scene)
    {
      const std::string     why  = "Wheel/Hub = mass: ";
      const TimeParameters &time = scene.time;
      if (scene.contact.normal_load && !time.hold_approach)
        throw InputError(why + "with a constant Contact/Normal load nothing "
                               "moves the axle; set Time/Hold approach = true, "
                               "which takes the load as that of the start.");
      if (!time.approach.empty())
        throw InputError(why + "Time/Approach = " + time.approach +
                         " would move the axle, which moves by the forces on "
                         "it; leave it empty, or take Hub = clamped.");
      if (scene.analysis.records_run && scene.sound.estimate)
        throw InputError(why + "Sound/Estimate = true holds for a wheel whose "
                               "hub is held; set it to false, or take Hub = "
                               "clamped.");
    }
  } // namespace

  void SceneParameters::check_reduced_bodies() const
  {
    if (!marches())
      return;
    if (time.hold_approach && !contact.normal_load)
      throw InputError("Time/Hold approach = true: it keeps the approach that "
                       "a load gives at the start; give Contact/Normal load, "
                       "or set it to false.");
    if (time.hold_approach && (time.initial_state != InitialState::steady ||
                               !time.normal_load.empty()))
      throw InputError("Time/Hold approach = true: the approach is that of the "
                       "steady state at t = 0; take Time/Initial state = "
                       "steady and leave Time/Normal load empty.");
    if (!has_reduced_bodies() && mesh.compliance == Compliance::split)
      throw InputError(
        "Mesh/Compliance = split: all unknowns of bodies move in "
        "time by finite elements; take these, or Time/Bodies = "
        "reduced.");
    if (!has_reduced_bodies() && time.inertia && !wheel.dampers.number.empty())
      throw InputError("Wheel/Dampers: they hang on modes, and Time/Bodies = "
                       "full has none; leave it empty, or take Time/Bodies = "
                       "reduced.");
    if (!has_reduced_bodies())
      return;
    if (!time.approach.empty() && !wheel.dampers.number.empty() &&
        wheel.dampers.direction != "axial")
      throw InputError("Time/Approach = " + time.approach +
                       ": the hub would shake Wheel/Dampers in Damper "
                       "direction = " +
                       wheel.dampers.direction +
                       ", which is not computed; take axial dampers, or drive "
                       "by another entry.");
    const std::string why = "Time/Bodies = reduced: ";
    modes.check();
    if (!time.inertia)
      throw InputError(why + "Time/Inertia = false leaves nothing to reduce; "
                             "set it to true.");
    if (time.initial_state != InitialState::steady)
      throw InputError(why + "the run starts from a steady state; take "
                             "Time/Initial state = steady.");
    if (time.theta != 0.5)
      throw InputError(why + "Time/Theta = " + text_of(time.theta) +
                       ": their scheme is the implicit midpoint rule; set it "
                       "to 0.5.");
    if (time.mass != MassKind::lumped)
      throw InputError(why + "Time/Mass = consistent: modes are those of the "
                             "lumped mass; take lumped.");
    if (time.rayleigh_alpha > 0. || time.rayleigh_beta > 0.)
      throw InputError(why + "Time/Rayleigh alpha and beta are for full "
                             "bodies; set them to 0 and give Rayleigh mass "
                             "and stiffness of Wheel and Rail.");
    const auto given = axes();
    const bool has_speeds =
      std::any_of(given.begin(), given.end(), [](const TableAxis &axis) {
        return axis.entry == "Contact/Speed";
      });
    if ((!contact.speed && !has_speeds) || !time.speed.empty())
      throw InputError(why + "give a constant Contact/Speed in m/s and leave "
                             "Time/Speed empty.");
    if (!wheel.rigid && wheel.hub == Hub::free)
      throw InputError(why + "Wheel/Hub = free has no steady state; take "
                             "clamped, elastic or mass.");
    if (moves_axle())
      check_axle_in_time(*this);
    if (body_solver == BodySolver::distributed)
      throw InputError("Body solver = distributed: " + why +
                       "modes are found with a factor; take direct or "
                       "automatic, on one rank.");
  }

  void SceneParameters::check_excitation() const
  {
    const bool is_sweep = analysis.until_periodic; // it has its starts
    if (!marches() || (time.excite_mode == 0. && time.excite_velocity == 0.))
      return;
    const std::string why =
      "Time/Excite mode = " + text_of(time.excite_mode) +
      ", Excite velocity = " + text_of(time.excite_velocity) + ": ";
    if (!is_sweep && (time.excite_mode == 0. || time.excite_velocity == 0.))
      throw InputError(why + "one needs the other; give a frequency in Hz and "
                             "a velocity in m/s above 0, or 0 for both.");
    if (!has_reduced_bodies())
      throw InputError(why + "they are for Time/Bodies = reduced; set both "
                             "to 0.");
    if (contact.normal_load && !time.hold_approach)
      throw InputError(why + "vibrations are those under a constant approach; "
                             "set Time/Hold approach = true.");
    if (contact.friction_coefficient == 0.)
      throw InputError(why + "without friction (Contact/Friction coefficient "
                             "= 0) no vibration grows; set both to 0.");
    if (contact.forces.any() || !time.longitudinal_force.empty() ||
        !time.lateral_force.empty() || !time.spin_moment.empty())
      throw InputError(why + "vibrations are those under constant creepages; "
                             "ask for no forces of friction.");
    check_disturbed_state(*this, why);
  }

  void SceneParameters::check_friction_response() const
  {
    if (!contact.falling_friction() || !(marches() || analysis.linearises))
      return;
    const FrictionResponse response = friction_response();
    if (response == FrictionResponse::node)
      return;
    const std::string why =
      "Contact/Friction response = " + contact.friction_response +
      (contact.friction_response == "automatic" ? " (patch mean): " : ": ");
    if (contact.friction_memory_length > 0.)
      throw InputError(why + "Contact/Friction memory length = " +
                       text_of(contact.friction_memory_length) +
                       " is a memory of each node; set it to 0 m, or take "
                       "node.");
    if (response == FrictionResponse::patch_mean &&
        !(contact.friction_memory > 0.))
      throw InputError(
        "Contact/Friction memory = " + text_of(contact.friction_memory) +
        ": patch mean needs a delay above 0 s; 60e-6 is usual.");
    if (!marches())
      return;
    if (!surfaces.friction_share.empty())
      throw InputError(why + "Surfaces/Friction share changes mu of each node; "
                             "leave it empty, or take node.");
    if (response == FrictionResponse::constant &&
        time.initial_state != InitialState::steady)
      throw InputError(why + "mu stays what it is in the steady state at t = "
                             "0; take Time/Initial state = steady.");
    const double h =
      time.steps(time.histories(contact, prm_folder).speed).length;
    if (response == FrictionResponse::patch_mean &&
        h > 0.1 * contact.friction_memory * (1 + 1e-9))
      throw InputError(
        "Contact/Friction memory = " + text_of(contact.friction_memory) +
        " s: steps of " + significant(h, 4) +
        " s are longer than a tenth of it; take a shorter "
        "Time/Time step.");
  }
} // namespace RollingContact
