#ifndef rolling_contact_time_sound_output_h
#define rolling_contact_time_sound_output_h

#include <rolling_contact/run/history_table.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/contact_stepper.h>
#include <rolling_contact/time/sound_report.h>

namespace RollingContact
{
  /**
   * The sound of a transient run of reduced bodies: it keeps the velocities of
   * the modes up to Modes/Maximum frequency at the end of each step in
   * modal_velocities.csv, and estimates from them at the end what the bodies
   * radiate.
   */
  template <int dim>
  class SoundOutput
  {
  public:
    /**
     * Find what the surfaces of the bodies radiate, and start
     * modal_velocities.csv or continue that of @p checkpoint if the run is
     * resumed. Throws InputError as Sound::radiating_body() does.
     */
    SoundOutput(const Situation           &scene,
                const ContactStepper<dim> &stepper,
                const Checkpoint          &checkpoint,
                RunContext                &context);

    /**
     * Add the row of the step just taken, which ended at @p time. Units: s.
     */
    void add_row(const ContactStepper<dim> &stepper, const double time);

    /**
     * Returns when all rows are on the disk.
     */
    HistoryTable::Position flush()
    {
      return table->flush();
    }

    /**
     * modal_velocities.csv under its final name, and what report_sound()
     * writes, of a motion with this period; 0 if it has none. Units: s.
     */
    void finish(const double period);

  private:
    const Situation            &scene;
    RunContext                 &context;
    std::vector<SoundingBody>   bodies;
    std::vector<std::size_t>    kept; ///< of all modes, numbers
    std::optional<HistoryTable> table;
  };
} // namespace RollingContact

#endif
