#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_declarations.h>
#include <rolling_contact/scene/scene_parameters.h>

namespace RollingContact
{
  namespace
  {
    /** Of a run that has so many steps: enough for a dozen periods. */
    const std::uint64_t least_steps = 1000;
  } // namespace



  void
  SceneParameters::check_cycles() const
  {
    if (!looks_for_cycles())
      return;
    const bool        is_sweep = analysis == "limit cycle";
    const std::string why      = is_sweep ? "Analysis = limit cycle: "
                                          : "Time/Stop when periodic = true: ";
    if (!time.inertia)
      throw InputError(why + "Time/Inertia = false has no vibration; set it to "
                             "true.");
    const TimeSteps steps =
      time.steps(time.histories(contact, prm_folder).speed);
    const double end = steps.length * steps.number;
    if (time.periodic_after >= end)
      throw InputError("Time/Periodic after = " + text_of(time.periodic_after) +
                       ": the run ends at " + significant(end, 6) +
                       " s; leave less of it out, or take a later Time/End "
                       "time.");
    if (steps.number < least_steps)
      throw InputError(why + "the run has " + std::to_string(steps.number) +
                       " steps, and periods are looked for in the last quarter "
                       "of at least 1000; take a later Time/End time.");
    if (!is_sweep)
      return;
    limit_cycle.check();
    if (contact.slip_operator != SlipOperatorKind::upwind_2)
      throw InputError(why + "Contact/Slip operator must be `upwind 2`, for "
                             "which vibrations that grow are found.");
    if (time.bodies != BodiesInTime::reduced)
      throw InputError(why + "bodies are reduced once for all runs; take "
                             "Time/Bodies = reduced.");
    if (!(time.excite_velocity > 0.))
      throw InputError(
        why + "Time/Excite velocity = " + text_of(time.excite_velocity) +
        ": it is what each start begins with; give a velocity "
        "above 0 m/s.");
    if (time.excite_mode != 0.)
      throw InputError(why + "Time/Excite mode = " + text_of(time.excite_mode) +
                       ": the starts are those of Limit cycle/Starts; set it "
                       "to 0.");
  }
} // namespace RollingContact
