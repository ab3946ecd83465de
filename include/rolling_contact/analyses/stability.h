#ifndef rolling_contact_analyses_stability_h
#define rolling_contact_analyses_stability_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>

namespace RollingContact
{
  /**
   * Analysis = stability: the steady rolling state, the eigenvalues of small
   * vibrations about it, the unstable ones counted a second time and proved
   * with the whole bodies, in stability.csv.
   */
  template <int dim>
  class Stability : public Analysis
  {
  public:
    Stability(const Situation &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void run() override;

  private:
    const Situation &scene;
    RunContext      &context;
  };

  AnalysisKind stability_kind();
} // namespace RollingContact

#endif
