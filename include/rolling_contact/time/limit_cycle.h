#ifndef rolling_contact_time_limit_cycle_h
#define rolling_contact_time_limit_cycle_h

#include <rolling_contact/algebra/cycle_measures.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/time/cycle_watch.h>

#include <complex>
#include <optional>

namespace RollingContact
{
  /**
   * What a run has come to, and what its limit cycle is like, if it is one.
   *
   * Energies of a cycle: what drives does the work `drive`, rigid creepage
   * against friction and the load against the approach. Sliding turns `heat` of
   * it into heat; the rest, `vibration`, is what the contact gives to the
   * vibration of the bodies, which damping and the scheme take again. In a
   * cycle nothing is stored.
   */
  class LimitCycle
  {
  public:
    /**
     * @p eigenvalue: of the vibration the run began in. Keeps a reference to
     * the watch. Units: 1/s.
     */
    LimitCycle(CycleWatch                                &watch,
               const std::optional<std::complex<double>> &eigenvalue);

    /** Columns cycle_... of results.csv, empty where there is no cycle. */
    void add_columns(ResultsTable &row) const;

    /** The findings of a run, and a warning if it has ended too soon. */
    void note(RunContext &context) const;

    /** cycle.csv: amplitudes of ten harmonics, if there is a cycle. */
    void write_harmonics(RunContext &context) const;

    /** cycle.svg: phase portrait, T over sliding velocity, two periods. */
    void draw(RunContext &context) const;

    Cycles::Motion motion() const
    {
      return verdict.motion;
    }

    bool is_periodic() const
    {
      return verdict.motion == Cycles::Motion::periodic;
    }

    /** Units: s. */
    double period() const
    {
      return verdict.period.length * verdict.step;
    }

  private:
    using Values = std::vector<double>;

    const Values &column(const std::string &name) const
    {
      return watch.column(name);
    }

    /** Whether the history has it. */
    bool has(const std::string &name) const
    {
      return !column(name).empty();
    }

    /** Means of numbers of nodes over the rows of the last whole periods. */
    struct Shares
    {
      double stick_time = 0.; ///< in which any node sticks
      double stick_node = 0.; ///< of the nodes that touch
      double open_time  = 0.; ///< without contact
      double sticking   = 0.; ///< nodes that stick while some do
    };

    Shares shares() const;

    /** Per cycle, in the order of the columns. Units: J. */
    std::vector<std::pair<std::string, double>> energies() const;

    void add_ranges(ResultsTable &row) const;

    /** Columns and what they are called in a picture. */
    using Names = std::vector<std::pair<std::string, std::string>>;

    /**
     * Names of the signals whose range is not negligible against the largest
     * range among them.
     */
    Names that_move(const Names &names) const;

    /** x or y, whichever the contact moves more along. */
    char direction() const;

    CycleWatch                         &watch;
    const Cycles::Verdict               verdict;
    std::optional<std::complex<double>> eigenvalue;
    std::optional<Cycles::WholePeriods> whole; ///< or all that was judged
  };
} // namespace RollingContact

#endif
