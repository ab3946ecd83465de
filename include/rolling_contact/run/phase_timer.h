#ifndef rolling_contact_run_phase_timer_h
#define rolling_contact_run_phase_timer_h

#include <string>
#include <thread>
#include <vector>

namespace RollingContact
{
  /**
   * What a run spends its time on.
   */
  enum class Phase
  {
    start,
    mesh,
    condensation,
    mass,
    modes,
    response,
    eigenvalues,
    body_solves,
    contact_solve,
    fields,
    checkpoints,
    step_estimate, ///< with all that it calls
    other
  };

  /**
   * "mesh and assembly", "contact solve", ...: the name in tables and run.json.
   */
  std::string name_of(const Phase phase);

  /**
   * Wall and CPU seconds per phase, from the construction of the timer
   * on, and of the start of the process if charge_start() is called. At any
   * instant exactly one phase is charged, the innermost open one or
   * Phase::other, so the rows sum to the run; what is opened within
   * Phase::step_estimate is charged to that, as it is done for the estimate
   * alone. The CPU time is that of the process: threads count. Scopes opened in
   * another thread than the one that made the timer count nothing; their time
   * stays with the phase open in that thread.
   */
  class PhaseTimer
  {
  public:
    struct Row
    {
      Phase        phase;
      unsigned int n_calls;
      double       wall_seconds;
      double       cpu_seconds;
    };

    /** Charges a phase while it lives. Scopes close in reverse order. */
    class Scope
    {
    public:
      Scope(PhaseTimer &timer, const Phase phase);
      ~Scope();

      Scope(const Scope &)            = delete;
      Scope &operator=(const Scope &) = delete;

    private:
      PhaseTimer *timer;
    };

    PhaseTimer();

    /**
     * Charge what the process took before the timer was made, most of it for
     * loading its libraries, to Phase::start. Wall time to 10 ms.
     */
    void charge_start();

    /** The phases in the order of first use, then Phase::other; open ones count
     * up to now. */
    std::vector<Row> rows() const;

    /** The sum of the rows, under Phase::other. */
    static Row total(const std::vector<Row> &rows);

    /** The rows, their total and shares as a table of 80 columns. */
    std::string summary() const;

  private:
    struct Instant
    {
      double wall;
      double cpu;
    };

    static Instant now();
    static void    charge(Row &row, const Instant &begin, const Instant &end);

    void enter(const Phase phase);
    void leave();

    const std::thread::id    owner;
    Instant                  last_change;
    std::vector<Row>         phases;
    std::vector<std::size_t> open_phases;
  };
} // namespace RollingContact

#endif
