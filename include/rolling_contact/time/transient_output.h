#ifndef rolling_contact_time_transient_output_h
#define rolling_contact_time_transient_output_h

#include <rolling_contact/run/history_table.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/time/contact_stepper.h>
#include <rolling_contact/time/cycle_watch.h>
#include <rolling_contact/time/history_rows.h>
#include <rolling_contact/time/sound_output.h>

#include <optional>

namespace RollingContact
{
  /**
   * What a transient run writes: a row of history.csv for each step, fields
   * every Time/Field interval steps as a time series, the last state in
   * results.csv, and a plot of the forces.
   */
  template <int dim>
  class TransientOutput
  {
  public:
    /**
     * Start history.csv and the series of fields, or continue those of
     * @p checkpoint if the run is resumed.
     */
    TransientOutput(const Situation           &scene,
                    RunContext                &context,
                    const Checkpoint          &checkpoint,
                    const ContactStepper<dim> &stepper);

    /**
     * Add the row of the step just taken; @p progress includes it.
     */
    void add_row(const ContactStepper<dim> &stepper,
                 const StepOutcome         &outcome,
                 const TransientProgress   &progress);

    /**
     * Write the fields of the state, if this step is to have any, or if it is
     * the last.
     */
    void write_fields(const ContactStepper<dim> &stepper,
                      const TransientProgress   &progress,
                      const bool                 last);

    /**
     * Rows on the disk, then a checkpoint of the run; @p files are those the
     * scene names.
     */
    void write_checkpoint(const ContactStepper<dim> &stepper,
                          const TransientProgress   &progress,
                          const PrmEntries          &files);

    /**
     * Whether the run is to end as its motion repeats itself, or nothing
     * moves, see Time/Stop when periodic.
     */
    bool settled()
    {
      return watch && watch->settled();
    }

    /**
     * End the output: history.csv under its final name, results.csv, the
     * largest load, the plot.
     */
    void finish(const ContactStepper<dim> &stepper,
                const TransientProgress   &progress);

    /** Period of the limit cycle that the run has come to; 0 without one.
     * Units: s. */
    double period() const
    {
      return found_period;
    }

  private:
    /**
     * What the run has come to, into the row of results.csv, and cycle.csv.
     */
    void measure_cycle(const ContactStepper<dim> &stepper);

    /**
     * Note the largest load of the whole history as a finding of the run.
     */
    void note_largest_load() const;

    const Situation            &scene;
    RunContext                 &context;
    const HistoryRows           rows;
    std::optional<HistoryTable> history;
    std::optional<CycleWatch>   watch;
    double                      found_period = 0.;

    std::optional<SoundOutput<dim>> sound;

    std::vector<PvdBlock> body_fields, interface_fields; ///< written
  };
} // namespace RollingContact

#endif
