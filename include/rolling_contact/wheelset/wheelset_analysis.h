#ifndef rolling_contact_wheelset_wheelset_analysis_h
#define rolling_contact_wheelset_wheelset_analysis_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/wheelset/wheelset_report.h>
#include <rolling_contact/wheelset/wheelset_solver.h>

namespace RollingContact
{
  /**
   * Analysis = wheelset: where a wheelset or a bogie runs in balance, on
   * straight track or in one curve after the other, and what its wheels do
   * there. A row of wheelset.csv for each wheelset and curve and two of
   * results.csv, one for each wheel; fields, lines across and pictures of both
   * wheels. Throws ConvergenceError at the first curve without an equilibrium;
   * the rows before it are kept.
   */
  class WheelsetAnalysis : public Analysis
  {
  public:
    WheelsetAnalysis(const Situation &scene, RunContext &context)
      : scene(scene)
      , context(context)
      , solver(scene)
      , report(scene, scene.inputs->own<WheelsetParameters>(), context)
    {}

    void run() override;

  private:
    void write_fields(const FoundEquilibrium &found,
                      const std::size_t       number,
                      const std::size_t       of);

    const Situation &scene;
    RunContext      &context;
    WheelsetSolver   solver;
    WheelsetReport   report;
  };

  AnalysisKind wheelset_kind();
} // namespace RollingContact

#endif
