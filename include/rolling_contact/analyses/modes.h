#ifndef rolling_contact_analyses_modes_h
#define rolling_contact_analyses_modes_h

#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/vibration/vibrating_body.h>

namespace RollingContact
{
  /**
   * Analysis = modes: eigenfrequencies and mode shapes of the elastic bodies up
   * to a frequency, in modes.csv, as a picture over the nodal diameters and as
   * moving surfaces for ParaView.
   */
  template <int dim>
  class Modes : public Analysis
  {
  public:
    Modes(const Situation &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void run() override;

  private:
    void add_rows(const VibratingBody<dim> &body, ResultsTable &table) const;

    void animate(const VibratingBody<dim> &body) const;

    void summarise(const VibratingBody<dim> &body) const;

    const Situation &scene;
    RunContext      &context;
  };

  AnalysisKind modes_kind();
} // namespace RollingContact

#endif
