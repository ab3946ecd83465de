#ifndef rolling_contact_analyses_quasi_static_h
#define rolling_contact_analyses_quasi_static_h

#include <rolling_contact/analyses/analysis.h>
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
    QuasiStatic(const SceneParameters &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void
    run() override;

  private:
    void
    report_no_contact();

    void
    summarise(const SteadyState<dim> &steady);

    void
    write_residuals(const SteadyState<dim> &steady) const;

    void
    write_fields(const SteadyState<dim> &steady);

    SceneParameters scene; ///< its own, with the mesh of a target error
    RunContext     &context;
  };
} // namespace RollingContact

#endif
