#ifndef rolling_contact_analyses_quasi_static_h
#define rolling_contact_analyses_quasi_static_h

#include <rolling_contact/program/analysis.h>
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

    const SceneParameters &scene;
    RunContext            &context;
  };

  /**
   * Log and note in run.json the sizes and cost of the static factors.
   */
  template <int dim>
  void
  describe_factors(const SteadyState<dim> &steady, RunContext &context);

  /**
   * Log how bodies from files are coupled to the interface.
   */
  template <int dim>
  void
  describe_surfaces(const RollingPair<dim> &pair, RunContext &context);

  /**
   * Log the sizes and cost of the bodies and note in run.json what was built
   * and what the scene did not need.
   */
  template <int dim>
  void
  describe_bodies(const SteadyState<dim> &steady, RunContext &context);
} // namespace RollingContact

#endif
