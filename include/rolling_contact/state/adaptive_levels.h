#ifndef rolling_contact_state_adaptive_levels_h
#define rolling_contact_state_adaptive_levels_h

#include <rolling_contact/contact/refinement_marks.h>
#include <rolling_contact/state/state_finder.h>

namespace RollingContact
{
  /**
   * A steady state on a sequence of meshes, each made by refining the one
   * before where its state asks for it: solve, mark, refine both bodies alike,
   * transfer the state, solve again. Ends at Mesh/Adaptive levels, at
   * Mesh/Target change of the forces, or before Mesh/Contact node budget is
   * exceeded; when the budget is short, the less urgent marks are left out
   * first. Just one solve when the scene asks for no levels.
   */
  template <int dim>
  class AdaptiveLevels
  {
  public:
    AdaptiveLevels(const PairSpec     &scene,
                   const StateDemands &demands,
                   RunContext         &context)
      : scene(scene)
      , demands(demands)
      , context(context)
    {
      if (scene.mesh.adaptive_levels > 0) // marked by strains
        this->demands.pair.displacements = true;
    }

    /**
     * The last level's state. @p on_level is called with each level's, in
     * order. A level that does not converge is the last. Throws InputError if
     * the first mesh exceeds the budget.
     */
    SteadyState<dim>
    run(const std::function<void(const SteadyState<dim> &)> &on_level);

  private:
    /**
     * Throws InputError, before anything is meshed.
     */
    void check_budget() const;

    /**
     * The next level's grading; false, with the reason said, if the budget does
     * not allow one.
     */
    bool refine(const SteadyState<dim> &steady, Grading<dim> &grading);

    bool refine_uniformly(const SteadyState<dim> &steady,
                          Grading<dim>           &grading);

    bool refine_marked(const SteadyState<dim> &steady, Grading<dim> &grading);

    void add_bulk_boxes(const SteadyState<dim> &steady, Grading<dim> &grading);

    const PairSpec &scene;
    StateDemands    demands;
    RunContext     &context;
  };
} // namespace RollingContact

#endif
