#ifndef rolling_contact_wheelset_wheelset_analysis_h
#define rolling_contact_wheelset_wheelset_analysis_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/wheelset/curve_walk.h>
#include <rolling_contact/wheelset/wheelset_report.h>

#include <vector>

namespace RollingContact
{
  /**
   * Analysis = wheelset: where a wheelset runs in balance, on straight track or
   * in one curve after the other, and what its wheels do there. A row of
   * wheelset.csv for each curve and two of results.csv, one for each wheel;
   * fields, lines across and pictures of both wheels. Throws ConvergenceError
   * at the first curve without an equilibrium; the rows before it are kept.
   */
  class WheelsetAnalysis : public Analysis
  {
  public:
    WheelsetAnalysis(const Situation &scene, RunContext &context);

    void run() override;

  private:
    /** The equilibrium of a case, on meshes of its own patches. */
    FoundEquilibrium refined(const WheelsetState &walked);

    /** Both wheels as they stand in the track, with their errors. */
    void finish(FoundEquilibrium &found);

    /** Another equilibrium of the last case, if there is one. */
    void search_another(FoundEquilibrium &found);

    void write_fields(const FoundEquilibrium &found,
                      const std::size_t       number,
                      const std::size_t       of);

    const Situation         &scene;
    RunContext              &context;
    const bool               is_mirrored; ///< solved as a curve to the right
    const WheelsetParameters wheelset;    ///< as it is solved
    WheelPair                rough, fine;
    Equilibrium              rough_balance, fine_balance;
    WheelsetReport           report;
  };

  AnalysisKind wheelset_kind();
} // namespace RollingContact

#endif
