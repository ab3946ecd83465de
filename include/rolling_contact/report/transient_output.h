#ifndef rolling_contact_report_transient_output_h
#define rolling_contact_report_transient_output_h

#include <rolling_contact/run/history_table.h>
#include <rolling_contact/state/contact_stepper.h>

#include <optional>

namespace RollingContact
{
  /**
   * What a transient run writes: a row of history.csv for each step, fields
   * every Time/Field interval steps as a time series, the last state in
   * results.csv, and a plot of the forces. Counts energies in the checkpoint it
   * is given, which is the run's own record.
   */
  template <int dim>
  class TransientOutput
  {
  public:
    /**
     * Starts history.csv, or continues it if the run is resumed.
     */
    TransientOutput(const SceneParameters &scene,
                    RunContext            &context,
                    const Checkpoint      &record);

    /**
     * The row of the step just taken; sums of the record include it.
     */
    void
    add_row(const ContactStepper<dim> &stepper,
            const StepOutcome         &outcome,
            const Checkpoint          &record);

    /**
     * Fields of the state, if this step is to have any, or if it is the last.
     */
    void
    write_fields(const ContactStepper<dim> &stepper,
                 Checkpoint                &record,
                 const bool                 last);

    /**
     * Rows on the disk, then the record and the bodies' state.
     */
    void
    write_checkpoint(const ContactStepper<dim> &stepper, Checkpoint &record);

    /**
     * history.csv under its final name, results.csv, the largest load, the
     * plot.
     */
    void
    finish(const ContactStepper<dim> &stepper, const Checkpoint &record);

  private:
    /**
     * Of the whole history, as a finding of the run.
     */
    void
    note_largest_load() const;

    void
    plot() const;

    const SceneParameters      &scene;
    RunContext                 &context;
    std::optional<HistoryTable> history;
  };
} // namespace RollingContact

#endif
