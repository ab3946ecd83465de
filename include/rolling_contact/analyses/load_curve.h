#ifndef rolling_contact_analyses_load_curve_h
#define rolling_contact_analyses_load_curve_h

#include <rolling_contact/scene/analysis_kind.h>
#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/steady_state.h>

#include <vector>

namespace RollingContact
{
  class Entries;

  /**
   * Section `Load curve`.
   */
  struct LoadCurveParameters
  {
    void declare(Entries &entries);

    /**
     * Throws InputError if a fraction is not in (0, 1].
     */
    void check() const;

    /** Loads over that of section Contact. Units: 1. */
    std::vector<double> load_fractions{1.};
  };

  /**
   * Analysis = load curve: steady states under several loads on one mesh, with
   * the contact stiffness k = dN/d(approach) of each, bulk of the bodies
   * included: the spring of a linearised wheel/rail model. One row per load in
   * results.csv, and a plot of load against approach. Throws ConvergenceError
   * at the first load that is not solved; the rows before it are kept.
   */
  template <int dim>
  class LoadCurve : public Analysis
  {
  public:
    LoadCurve(const Situation &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    void run() override;

  private:
    /**
     * Throws ConvergenceError if that fails.
     */
    void solve_at(const double load, SteadyState<dim> &steady) const;

    /**
     * Contact stiffness from the approaches under 10 % less and 10 % more load,
     * which is 0.07 % off for a Hertz contact; nodes that join and leave the
     * patch make smaller differences rough. Units: N/m.
     */
    double stiffness(SteadyState<dim> &steady) const;

    void plot() const;

    Situation           scene; ///< its own, with the mesh of a target error
    RunContext         &context;
    std::vector<double> loads, approaches, hertz; ///< N, m, m
  };

  AnalysisKind load_curve_kind();
} // namespace RollingContact

#endif
