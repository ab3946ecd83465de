#ifndef rolling_contact_results_state_report_h
#define rolling_contact_results_state_report_h

#include <rolling_contact/results/uniqueness_warning.h>
#include <rolling_contact/run/run_context.h>
#include <rolling_contact/scene/pair_spec.h>
#include <rolling_contact/state/steady_state.h>

#include <limits>
#include <string>

namespace RollingContact
{
  /**
   * The work of a solver as "active set, 4 normal and 7 tangential solves in 3
   * passes; natural residual 1e-16 normal, 4e-16 tangential".
   */
  std::string work_of_solver(const SolverReport &solver);

  /**
   * Load and force of a state as the findings of a run.
   */
  template <int dim>
  void note_state(const SteadyState<dim> &steady, RunReport &report);

  /**
   * Tell how hot friction makes the surfaces and what mu has become there, if
   * it follows their temperature.
   */
  template <int dim>
  void note_hot_friction(const PairSpec         &scene,
                         const SteadyState<dim> &steady,
                         RunReport              &report);

  /**
   * Write tractions.svg: p/p0 and q/(mu p0) along the patch of a 2D state, with
   * Hertz and, where it applies, Carter.
   */
  void plot_line_tractions(const PairSpec       &scene,
                           const SteadyState<2> &steady,
                           RunContext           &context);

  /**
   * What must be said of the states of an analysis: the largest error of all of
   * them in the report, and warnings at the end.
   */
  template <int dim>
  class StateReview
  {
  public:
    StateReview(const PairSpec &scene, RunContext &context)
      : scene(scene)
      , context(context)
    {}

    /**
     * @p name says in a warning which of the states it is: "point 3".
     */
    void add(const SteadyState<dim> &steady, const std::string &name = "");

    /**
     * Warn where fewer than five nodes touched or several solutions must be
     * expected, where the edge law was left out or did not settle, where
     * another solver stood in, where the normals of profiles turn over the
     * plane of contact, and of the strains of the last state if they are
     * large; tell_rough_state() of it.
     */
    void warn(const SteadyState<dim> &last) const;

  private:
    void warn_of_turning_normal(const SteadyState<dim> &last) const;

    /** The load as pairs of the place across (m) and a force (N). */
    void
    warn_of_slope(const std::vector<std::pair<double, double>> &load) const;

    void note_slip_rows(const SteadyState<dim> &steady);

    const PairSpec          &scene;
    RunContext              &context;
    UniquenessSummary        worst;
    std::size_t              n_states = 0, n_edges = 0, n_unresolved = 0;
    std::vector<std::string> ways; ///< of solving that were not the plain one
    unsigned int             fewest = std::numeric_limits<unsigned int>::max();
  };
} // namespace RollingContact

#endif
