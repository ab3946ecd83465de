#include <fmt/format.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_text.h>
#include <rolling_contact/results/error_bounds.h>
#include <rolling_contact/results/result_row.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/tables/kept_states.h>
#include <rolling_contact/tables/session.h>

#include <stdexcept>

namespace RollingContact
{
  /**
   * What does not depend on the dimension: entries, and the state solved last.
   */
  class Session::Implementation
  {
  public:
    explicit Implementation(const Situation &scene)
      : entries(scene)
    {}

    virtual ~Implementation() = default;

    /** Solve a scene whose bodies touch. */
    virtual void solve(const Situation &scene, const std::string &bodies) = 0;

    virtual void add_row(ResultsTable &table) = 0;

    virtual unsigned int n_made() const = 0;

    SceneEntries          entries;
    SessionState          found;
    const ContactProblem *problem = nullptr;
    const ContactState   *state   = nullptr;
    bool is_changed = false; ///< entries, since the state was solved
  };

  namespace
  {
    void refuse_what_is_for_one_state(const Situation &scene)
    {
      if (scene.mesh.target_error || scene.mesh.adaptive_levels > 0)
        throw InputError("Mesh/Target error and Mesh/Adaptive levels make a "
                         "mesh for one state, a session keeps its bodies for "
                         "others: leave the target empty and set the levels to "
                         "0.");
    }

    template <int dim>
    class Bodies : public Session::Implementation
    {
    public:
      Bodies(const Situation &scene,
             std::ostream    *log,
             const Verbosity  verbosity)
        : Implementation(scene)
        , states(log, verbosity)
      {}

      void solve(const Situation &scene, const std::string &bodies) override
      {
        problem = nullptr;
        report(scene, states.solve(scene, bodies));
      }

      void add_row(ResultsTable &table) override
      {
        const RunContext &run = states.context.run;
        RunContext own{run.folder, table, run.report, run.timer, run.log};
        add_result_row(entries.situation(), *steady, own);
      }

      unsigned int n_made() const override
      {
        return states.n_made;
      }

    private:
      void report(const Situation &scene, SteadyState<dim> &steady);

      KeptStates<dim>   states;
      SteadyState<dim> *steady = nullptr; ///< solved last
    };

    template <int dim>
    void Bodies<dim>::report(const Situation &scene, SteadyState<dim> &steady)
    {
      estimate_errors(scene, steady);
      this->steady     = &steady;
      problem          = &steady.problem;
      state            = &steady.state;
      found            = session_state(scene, steady);
      found.new_bodies = states.why_new;
      states.context.run.log.message(
        "T = (" + significant(found.forces.force_x, 6) + ", " +
        significant(found.forces.force_y, 6) +
        ") N, N = " + significant(found.forces.normal_force, 6) + " N" +
        (found.converged ? "" : ", not converged: " + found.reason) +
        (found.new_bodies.empty() ? "; bodies kept"
                                  : "; new bodies: " + found.new_bodies) +
        '.');
    }
  } // namespace

  template <int dim>
  SessionState session_state(const PairSpec         &scene,
                             const SteadyState<dim> &steady)
  {
    SessionState found;
    found.touches   = true;
    found.converged = steady.solver.converged;
    found.reason    = steady.solver.reason;
    found.solver    = steady.solver;
    found.approach  = steady.state.approach;
    found.creepages = steady.problem.loads.creepages;
    found.forces    = steady.result;
    found.areas     = patch_areas(steady.problem, steady.state);
    found.elements_across =
      2 * steady.result.half_width_x / steady.grading.element_size_x;
    if (scene.frame)
      found.track_forces = track_forces(scene, steady.problem, steady.state);
    if (found.converged)
      found.bounds = error_bounds(scene, steady);
    return found;
  }

  template SessionState session_state(const PairSpec &, const SteadyState<3> &);

  Session::Session(const Situation &scene,
                   std::ostream    *log,
                   const Verbosity  verbosity)
  {
    refuse_what_is_for_one_state(scene);
    if (scene.dimension == 2)
      implementation = std::make_unique<Bodies<2>>(scene, log, verbosity);
    else
      implementation = std::make_unique<Bodies<3>>(scene, log, verbosity);
  }

  Session::~Session() = default;

  Session::Session(Session &&) noexcept = default;

  Session &Session::operator=(Session &&) noexcept = default;

  void Session::set(const std::string &entry, const std::string &value)
  {
    const std::string problem = problem_of_value(value);
    if (!problem.empty())
      throw InputError(entry + ": " + problem);
    if (entry == "Dimension")
      throw InputError("Dimension = " + value +
                       ": a session keeps its dimension; make another one.");
    implementation->entries.check(entry, value, "");
    implementation->entries.set(entry, value);
    implementation->is_changed = true;
  }

  void Session::set(const std::string &entry, const double value)
  {
    set(entry, fmt::format("{}", value));
  }

  const SessionState &Session::solve()
  {
    const Stopwatch watch;
    throw_if_interrupted();
    implementation->found      = SessionState();
    implementation->problem    = nullptr;
    implementation->is_changed = false;
    implementation->entries.check_scene();
    const Situation &scene = implementation->entries.situation();
    refuse_what_is_for_one_state(scene);
    SessionState &found = implementation->found;
    found.creepages     = scene.contact.creepages;
    found.touches       = bodies_touch(scene);
    found.converged     = !found.touches;
    if (found.touches)
      implementation->solve(scene, implementation->entries.bodies_key());
    found.seconds = watch.seconds();
    return found;
  }

  const ContactProblem &Session::problem() const
  {
    if (!implementation->problem)
      throw std::logic_error("The session has no state that touches.");
    return *implementation->problem;
  }

  const ContactState &Session::state() const
  {
    problem();
    return *implementation->state;
  }

  std::vector<Session::NamedValue> Session::row() const
  {
    problem();
    if (implementation->is_changed)
      throw std::logic_error("An entry was given another value since the state "
                             "was solved: solve it again.");
    ResultsTable table;
    implementation->add_row(table);
    std::vector<NamedValue> found;
    for (const std::string &column : table.columns())
      {
        const std::string text = table.text(0, column);
        if (const auto number = table.number(0, column))
          found.emplace_back(column, *number);
        else if (text.empty())
          found.emplace_back(column, std::monostate());
        else
          found.emplace_back(column, text);
      }
    return found;
  }

  unsigned int Session::n_bodies_made() const
  {
    return implementation->n_made();
  }
} // namespace RollingContact
