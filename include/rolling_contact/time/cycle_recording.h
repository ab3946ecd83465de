#ifndef rolling_contact_time_cycle_recording_h
#define rolling_contact_time_cycle_recording_h

#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/contact_stepper.h>

namespace RollingContact
{
  /**
   * Take the steps of one more period beyond the end of a run, which they are
   * no part of, and record them: cycle_patch.csv, the nodes of the line along x
   * through the middle of the patch that touch in it, and cycle_patch.svg,
   * which of them are open, slip or stick; with Output/Interface fields 24
   * phases of the interface, cycle.pvd. If a step fails there is a warning and
   * no record. @p time: where the first step begins, @p h: length of the steps,
   * both in s, as the @p period. States are recorded at the ends of steps.
   */
  template <int dim>
  void record_cycle(const Situation     &scene,
                    const double         time,
                    const double         h,
                    const double         period,
                    ContactStepper<dim> &stepper,
                    RunContext          &context);
} // namespace RollingContact

#endif
