#ifndef rolling_contact_wheelset_wheelset_report_h
#define rolling_contact_wheelset_wheelset_report_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/wheelset/found_equilibrium.h>

#include <vector>

namespace RollingContact
{
  /**
   * What the equilibria of a run are told by: wheelset.csv, results.csv,
   * wheelset.svg, findings and warnings.
   */
  class WheelsetReport
  {
  public:
    WheelsetReport(const Situation          &scene,
                   const WheelsetParameters &wheelset,
                   RunContext               &context);

    /** The wheelset of a case, or both of a bogie. */
    void add(const std::vector<FoundEquilibrium> &found);

    /** A row of wheelset.csv alone, of a place in this scene. */
    void add_row(const PairSpec &at, const FoundEquilibrium &found);

    /** What the wheelset does there, in the summary and as warnings. */
    void tell(const FoundEquilibrium &found)
    {
      note(found);
      warn(found);
    }

    /** Once all are there. */
    void finish();

  private:
    void add_wheel(const FoundEquilibrium &found, const unsigned int wheel);

    void note(const FoundEquilibrium &found);

    void add_hunting(const FoundEquilibrium &found);

    void warn(const FoundEquilibrium &found);

    void plot() const;

    const Situation          &scene;
    const WheelsetParameters &wheelset;
    RunContext               &context;
    ResultsTable              table;

    /** The wheelsets of each case. */
    std::vector<std::vector<WheelsetState>> all;
  };
} // namespace RollingContact

#endif
