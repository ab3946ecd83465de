#ifndef rolling_contact_analyses_accuracy_study_h
#define rolling_contact_analyses_accuracy_study_h

#include <rolling_contact/analyses/study_summary.h>
#include <rolling_contact/run/progress.h>
#include <rolling_contact/scene/analysis.h>
#include <rolling_contact/scene/situation.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace RollingContact
{
  /**
   * Analysis = accuracy study with Vary = mesh: steady states of one scene on
   * several meshes, at several positions of each under the patch, for several
   * creepages, slip operators and solvers, against the converged solution of
   * the same bodies. One row per state in results.csv; tables and plot are left
   * to StudySummary. A state that is not solved is counted there; only the
   * reference must converge.
   */
  template <int dim>
  class AccuracyStudy : public Analysis
  {
  public:
    AccuracyStudy(const Situation &scene, RunContext &context);

    void run() override;

  private:
    /**
     * Creepage in the rolling direction, across it and in spin at which the
     * force saturates. Throws InputError without contact or friction.
     */
    Creepages saturation() const;

    void list_cases();

    void list_methods();

    /**
     * The reference mesh and those it is extrapolated from, where they are not
     * among the meshes to compare.
     */
    std::vector<unsigned int> meshes_of_reference_alone() const;

    /**
     * How many states the study has.
     */
    std::uint64_t n_states() const;

    /**
     * Solve the reference mesh and those it is extrapolated from.
     */
    void solve_reference();

    std::vector<std::size_t> methods_on(const std::string &mesh) const;

    /**
     * The study's scene on the meshes of a method, solved by it.
     */
    Situation scene_of(const std::size_t method) const;

    /**
     * A scene with the creepages of a case.
     */
    Situation with_case(Situation scene, const std::size_t index) const;

    /**
     * Bodies and compliance on a grading, its zone enlarged until it holds the
     * patch without friction.
     */
    SteadyState<dim> set_up(const Situation &scene, Grading<dim> grading);

    /**
     * Solve all positions of a uniform or graded mesh; its set-up is made once
     * for all methods and cases.
     */
    void solve_mesh(const std::string              &mesh,
                    const unsigned int              elements,
                    const std::vector<std::size_t> &methods);

    void solve_case(const StudyKey     &key,
                    const Situation    &scene,
                    const StateSeconds &set_up,
                    SteadyState<dim>   &steady);

    /**
     * Solve all positions of an adaptive mesh, whose levels belong to one
     * state.
     */
    void solve_levels(const unsigned int start, const std::size_t method);

    void solve_levels(const StudyKey &key, const double offset);

    void keep(const StudyKey         &key,
              const Situation        &scene,
              const StateSeconds     &seconds,
              const SteadyState<dim> &steady);

    const Situation           &scene;
    RunContext                &context;
    StateDemands               demands;
    const PatchEstimate        patch;
    StudyResults               results;
    std::vector<TractionField> finest; ///< of each case, once it is solved
    std::optional<Progress>    progress;
    std::uint64_t              n_done = 0; ///< states
  };
} // namespace RollingContact

#endif
