#ifndef rolling_contact_analyses_creep_curve_h
#define rolling_contact_analyses_creep_curve_h

#include <rolling_contact/analyses/analysis.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Analysis = creep curve: steady states along a path of creepages on one
   * mesh, with one factorisation and one condensation, each point started from
   * the one before. One row per point in results.csv, and a plot of |T|/(mu N)
   * with the references. Throws ConvergenceError at the first point that is not
   * solved; the rows before it are kept.
   */
  template <int dim>
  class CreepCurve : public Analysis
  {
  public:
    CreepCurve(const SceneParameters &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void
    run() override;

  private:
    /**
     * Solve each point and add its row of results.
     */
    void
    march(const std::vector<Creepages> &points, SteadyState<dim> &steady);

    void
    solve_point(const Creepages &creepages, SteadyState<dim> &steady);

    void
    plot(const std::vector<Creepages> &points) const;

    const SceneParameters &scene;
    RunContext            &context;
    std::vector<double>    force; ///< |T|/(mu N), mu_s N if friction falls

    /** |T|/(mu N) of a theory at each point. */
    struct ReferenceCurve
    {
      std::string         label;
      bool                saturates = true;
      std::vector<double> ratios;
    };
    std::vector<ReferenceCurve> references;
  };
} // namespace RollingContact

#endif
