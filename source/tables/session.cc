#include <fmt/format.h>

#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/input/prm_text.h>
#include <rolling_contact/scene/scene_entries.h>
#include <rolling_contact/state/estimate_errors.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/tables/kept_bodies.h>
#include <rolling_contact/tables/quiet_context.h>
#include <rolling_contact/tables/session.h>

#include <cmath>
#include <list>
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

    SceneEntries          entries;
    SessionState          found;
    const ContactProblem *problem = nullptr;
    const ContactState   *state   = nullptr;
    unsigned int          n_made  = 0;
  };

  namespace
  {
    const std::size_t most_kept = 4;

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
        , context(log, verbosity)
      {}

      void solve(const Situation &scene, const std::string &bodies) override;

    private:
      /** A state, and what its bodies are good for. */
      struct Kept
      {
        std::string      bodies;
        double           size; ///< of the patch, m
        SteadyState<dim> steady;
      };

      using Place = typename std::list<Kept>::iterator;

      /** The end if none serves; else it is the first then. */
      Place find(const std::string &bodies, const double size);

      void make(const Situation   &scene,
                const std::string &bodies,
                const double       size,
                const std::string &why);

      void report(const Situation &scene);

      QuietContext    context;
      std::list<Kept> kept; ///< the one that was used last first
    };

    template <int dim>
    typename Bodies<dim>::Place Bodies<dim>::find(const std::string &bodies,
                                                  const double       size)
    {
      Place nearest = kept.end();
      for (Place it = kept.begin(); it != kept.end(); ++it)
        if (it->bodies == bodies && size >= smallest_patch * it->size &&
            it->size >= smallest_patch * size &&
            (nearest == kept.end() ||
             std::abs(size - it->size) < std::abs(size - nearest->size)))
          nearest = it;
      if (nearest != kept.end())
        kept.splice(kept.begin(), kept, nearest);
      return nearest;
    }

    template <int dim>
    void Bodies<dim>::make(const Situation   &scene,
                           const std::string &bodies,
                           const double       size,
                           const std::string &why)
    {
      if (kept.size() == most_kept)
        kept.pop_back();
      ++n_made;
      found.new_bodies = why;
      SteadyState<dim> steady =
        solve_steady_state<dim>(scene, demands_of_kept_bodies(), context.run);
      steady.pair->release_statics();
      kept.push_front({bodies, size, std::move(steady)});
    }

    template <int dim>
    void Bodies<dim>::solve(const Situation &scene, const std::string &bodies)
    {
      const double size = patch_size(scene);
      problem           = nullptr;
      if (find(bodies, size) == kept.end())
        make(scene,
             bodies,
             size,
             kept.empty()
               ? "the first state"
               : "no bodies that are kept are made for " + bodies +
                   " and a patch of " + significant(size, 3) + " m half-width");
      else
        {
          SteadyState<dim> &steady = kept.front().steady;
          if (!steady.solver.converged)
            steady.state = initial_state(steady.problem, estimate_patch(scene));
          steady.solver.converged = false; // where it throws
          solve_on_kept_bodies(scene, steady);
          if (!steady.solver.converged)
            {
              steady.state =
                initial_state(steady.problem, estimate_patch(scene));
              solve_on_kept_bodies(scene, steady);
            }
          if (steady.solver.converged && zone_too_small(steady))
            {
              kept.pop_front();
              make(scene,
                   bodies,
                   size,
                   "the patch reaches the border of the candidate zone");
            }
        }
      report(scene);
    }

    template <int dim>
    void Bodies<dim>::report(const Situation &scene)
    {
      SteadyState<dim> &steady = kept.front().steady;
      estimate_errors(scene, steady);
      problem         = &steady.problem;
      state           = &steady.state;
      found.converged = steady.solver.converged;
      found.reason    = steady.solver.reason;
      found.solver    = steady.solver;
      found.approach  = steady.state.approach;
      found.creepages = steady.problem.loads.creepages;
      found.forces    = steady.result;
      found.areas     = patch_areas(steady.problem, steady.state);
      found.elements_across =
        2 * steady.result.half_width_x / steady.grading.element_size_x;
      if (found.converged)
        found.bounds = error_bounds(scene, steady);
      context.run.log.message(
        "T = (" + significant(found.forces.force_x, 6) + ", " +
        significant(found.forces.force_y, 6) +
        ") N, N = " + significant(found.forces.normal_force, 6) + " N" +
        (found.converged ? "" : ", not converged: " + found.reason) +
        (found.new_bodies.empty() ? "; bodies kept"
                                  : "; new bodies: " + found.new_bodies) +
        '.');
    }
  } // namespace

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
  }

  void Session::set(const std::string &entry, const double value)
  {
    set(entry, fmt::format("{}", value));
  }

  const SessionState &Session::solve()
  {
    const Stopwatch watch;
    throw_if_interrupted();
    implementation->found   = SessionState();
    implementation->problem = nullptr;
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

  unsigned int Session::n_bodies_made() const
  {
    return implementation->n_made;
  }
} // namespace RollingContact
