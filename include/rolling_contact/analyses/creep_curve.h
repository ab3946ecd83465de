#ifndef rolling_contact_analyses_creep_curve_h
#define rolling_contact_analyses_creep_curve_h

#include <rolling_contact/analyses/creep_curve_parameters.h>
#include <rolling_contact/analyses/creep_curve_plot.h>
#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  /**
   * Analysis = creep curve: steady states along a path of creepages, or of
   * forces, on one mesh, with one factorisation and one condensation, each
   * point started from the one before; a point whose patch reaches the border
   * of the candidate zone makes mesh and compliance again for a larger zone,
   * for itself and those after it. One row per point in results.csv, and a
   * plot. Throws ConvergenceError at the first point that is not solved; the
   * rows before it are kept.
   */
  template <int dim>
  class CreepCurve : public Analysis
  {
  public:
    CreepCurve(const Situation &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void run() override;

  private:
    /**
     * Solve each point and add its row of results.
     */
    void march(const std::vector<CreepCurvePoint> &points,
               SteadyState<dim>                   &steady);

    void solve_point(const CreepCurvePoint &point, SteadyState<dim> &steady);

    Situation        scene; ///< its own, with the mesh of a target error
    RunContext      &context;
    CreepCurveForces curve;
  };

  AnalysisKind creep_curve_kind();
} // namespace RollingContact

#endif
