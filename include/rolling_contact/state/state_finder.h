#ifndef rolling_contact_state_state_finder_h
#define rolling_contact_state_state_finder_h

#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <functional>

namespace RollingContact
{
  /**
   * Makes the pair of a scene on a grading of its interface; none: a
   * RollingPair with bodies of its own.
   */
  template <int dim>
  using PairMaker =
    std::function<std::shared_ptr<RollingPair<dim>>(const PairSpec &,
                                                    const Grading<dim> &)>;

  /**
   * Number of meshes that are made for a state before it is given up.
   */
  inline constexpr unsigned int most_meshes = 10;

  /**
   * Call @p solve(k) on mesh k = 0, 1, ... and @p next_mesh(k) after it, which
   * makes the next mesh and returns true, or false if none is needed. Returns
   * false if the last of most_meshes did not suffice.
   */
  template <typename Solve, typename NextMesh>
  bool solve_on_fitting_mesh(const Solve &solve, const NextMesh &next_mesh)
  {
    for (unsigned int k = 0; k < most_meshes; ++k)
      {
        solve(k);
        if (!next_mesh(k))
          return true;
      }
    return false;
  }

  /**
   * Finds steady states of a scene: makes mesh and compliance, solves, and does
   * so again as long as the patch does not fit the mesh. Keeps references to
   * its arguments.
   */
  template <int dim>
  class StateFinder
  {
  public:
    using Start = std::function<ContactState(const ContactProblem &)>;

    StateFinder(const PairSpec       &scene,
                const StateDemands   &demands,
                RunContext           &context,
                const PairMaker<dim> &make_pair = {})
      : scene(scene)
      , demands(keeping_split_bodies(demands))
      , context(context)
      , make_pair(make_pair)
    {}

    /**
     * Bodies, compliance and contact problem on this grading, not solved.
     */
    SteadyState<dim> set_up(const Grading<dim> &grading) const;

    /**
     * The state on this grading, solved from the one that @p start makes for
     * its problem.
     */
    SteadyState<dim> solve_on(const Grading<dim> &grading,
                              const Start        &start) const;

    /**
     * The state on a mesh that is made for the Hertz estimate and made again
     * when the patch turns out to differ much from it or reaches the border of
     * the candidate zone, and when it is to be aligned with the leading edge.
     * Throws ConvergenceError if no mesh fits.
     */
    SteadyState<dim> find() const;

    /**
     * The state on @p grading, its zone enlarged as long as the patch reaches
     * the border, each time from @p previous. Throws ConvergenceError that
     * begins with @p where if no zone encloses the patch.
     */
    SteadyState<dim> find_from(const SteadyState<dim> &previous,
                               Grading<dim>            grading,
                               const std::string      &where) const;

    /**
     * Solve a state that has its mesh, under the loads of its problem, from
     * where it is, and on larger zones with elements of the same size as long
     * as the patch reaches the border. A state that does not converge stays as
     * it is, and so does one that no zone encloses.
     */
    void solve_enclosed(SteadyState<dim> &steady) const;

  private:
    /**
     * Demands whose split bodies serve the next mesh as well.
     */
    static StateDemands keeping_split_bodies(StateDemands demands)
    {
      if (!demands.pair.split_bodies)
        demands.pair.split_bodies = std::make_shared<SplitBodies>();
      return demands;
    }

    /**
     * Whether a state that is solved needs a larger zone; if so the grading has
     * one, which is said. @p k: number of enlargements before.
     */
    bool enlarge_zone(const SteadyState<dim> &steady,
                      const unsigned int      k,
                      Grading<dim>           &grading) const;

    const PairSpec      &scene;
    const StateDemands   demands;
    RunContext          &context;
    const PairMaker<dim> make_pair;
  };

  /**
   * Say that a zone is larger than the one before.
   */
  template <int dim>
  void say_enlarged(const Grading<dim> &grading, Log &log);

  /**
   * StateFinder::find() of a scene.
   */
  template <int dim>
  SteadyState<dim> solve_steady_state(const PairSpec       &scene,
                                      const StateDemands   &demands,
                                      RunContext           &context,
                                      const PairMaker<dim> &make_pair = {})
  {
    return StateFinder<dim>(scene, demands, context, make_pair).find();
  }
} // namespace RollingContact

#endif
