#ifndef rolling_contact_evolution_profile_evolution_h
#define rolling_contact_evolution_profile_evolution_h

#include <rolling_contact/evolution/evolution_report.h>
#include <rolling_contact/scene/analysis_kind.h>

namespace RollingContact
{
  /**
   * Analysis = profile evolution: how wheels and rails wear under a duty, step
   * by step, see WearStep, to a distance, a depth or a limit of the flange.
   * Throws ConvergenceError, naming the row of the duty and the distance, where
   * a step has no balance however short it is; all steps before it are kept.
   */
  class ProfileEvolution : public Analysis
  {
  public:
    ProfileEvolution(const Situation &scene, RunContext &context);

    void run() override;

  private:
    /** A share of the way that is not much too long nor too short. */
    double first_share(const DutyStates &states) const;

    /** One step on, whose share may be shortened; @p states: of all rows on the
     * surfaces, before and after. */
    void take_step(DutyStates &states, double &share);

    /** All steps; why they ended. */
    std::string march(DutyStates &states);

    /** Why it ends before the way does; empty if it does not. */
    std::string limit_reached() const;

    std::string place() const;

    /** The state of the run, after each step. */
    void save() const;

    void restore();

    /** The file of rows as it is. */
    std::string duty_text() const;

    const Situation            &scene;
    const EvolutionParameters  &section;
    RunContext                 &context;
    const std::vector<DutyCase> duty;
    RunningSurfaces             surfaces;
    WearStep                    step;
    EvolutionReport             report;
    EvolutionPoint              now;
    double                      next_share = 0.;
  };

  AnalysisKind profile_evolution_kind();
} // namespace RollingContact

#endif
