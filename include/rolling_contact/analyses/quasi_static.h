#ifndef rolling_contact_analyses_quasi_static_h
#define rolling_contact_analyses_quasi_static_h

#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Analysis = quasi-static: one steady rolling state, its row in results.csv,
   * the fields and the plot the scene asks for. Throws ConvergenceError, after
   * writing what there is, when the state is not solved.
   */
  template <int dim>
  class QuasiStatic : public Analysis
  {
  public:
    QuasiStatic(const Situation &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void run() override;

  private:
    void report_no_contact();

    void summarise(const SteadyState<dim> &steady);

    void write_residuals(const SteadyState<dim> &steady) const;

    void write_fields(const SteadyState<dim> &steady);

    Situation   scene; ///< its own, with the mesh of a target error
    RunContext &context;
  };

  AnalysisKind quasi_static_kind();
} // namespace RollingContact

#endif
