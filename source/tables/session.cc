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

#include <algorithm>
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
        std::string           bodies;
        std::array<double, 2> element_size; ///< wanted, m
        std::vector<ZoneBox>  patches;      ///< where profiles touch
        SteadyState<dim>      steady;

        /** By how much wanted elements are larger or smaller, in logarithms. */
        double misfit(const WantedMesh &wanted) const;

        bool reaches(const WantedMesh &wanted) const;
      };

      /** Whether one serves; it is the first then. */
      bool find(const std::string &bodies, const WantedMesh &wanted);

      /** Solve on the first of those that are kept. */
      void solve_kept(const Situation &scene, const WantedMesh &wanted);

      void make(const Situation            &scene,
                const std::string          &bodies,
                const WantedMesh           &wanted,
                const std::vector<ZoneBox> &other_patches,
                const std::string          &why);

      void report(const Situation &scene);

      QuietContext                       context;
      const std::shared_ptr<SplitBodies> split_bodies =
        std::make_shared<SplitBodies>();
      std::list<Kept> kept; ///< the one that was used last first
    };

    template <int dim>
    double Bodies<dim>::Kept::misfit(const WantedMesh &wanted) const
    {
      double largest = 0.;
      for (unsigned int d = 0; d < dim - 1; ++d)
        largest = std::max(largest,
                           std::abs(std::log(wanted.element_size[d] /
                                             element_size[d])));
      return largest;
    }

    template <int dim>
    bool Bodies<dim>::Kept::reaches(const WantedMesh &wanted) const
    {
      const auto  &boxes     = wanted.patch.boxes;
      const double step      = steady.grading.element_size_x / 2;
      const auto   is_inside = [&](const ZoneBox &box) {
        return covers(steady.grading.zone_boxes, box, step) ||
               covers(patches, box, step);
      };
      return std::all_of(boxes.begin(), boxes.end(), is_inside);
    }

    template <int dim>
    bool Bodies<dim>::find(const std::string &bodies, const WantedMesh &wanted)
    {
      const double largest = -std::log(smallest_patch) * (1 + 1e-9);
      auto         nearest = kept.end();
      for (auto it = kept.begin(); it != kept.end(); ++it)
        if (it->bodies == bodies && it->misfit(wanted) <= largest &&
            (nearest == kept.end() ||
             it->misfit(wanted) < nearest->misfit(wanted)))
          nearest = it;
      if (nearest == kept.end())
        return false;
      kept.splice(kept.begin(), kept, nearest);
      return true;
    }

    template <int dim>
    void Bodies<dim>::make(const Situation            &scene,
                           const std::string          &bodies,
                           const WantedMesh           &wanted,
                           const std::vector<ZoneBox> &other_patches,
                           const std::string          &why)
    {
      if (kept.size() == most_kept)
        kept.pop_back();
      ++n_made;
      found.new_bodies          = why;
      StateDemands demands      = demands_of_kept_bodies();
      demands.pair.split_bodies = split_bodies;
      demands.other_patches     = other_patches;
      SteadyState<dim> steady =
        solve_steady_state<dim>(scene, demands, context.run);
      steady.pair->release_statics();
      kept.push_front(
        {bodies, wanted.element_size, wanted.patch.boxes, std::move(steady)});
      kept.front().patches.insert(kept.front().patches.end(),
                                  other_patches.begin(),
                                  other_patches.end());
    }

    template <int dim>
    void Bodies<dim>::solve_kept(const Situation  &scene,
                                 const WantedMesh &wanted)
    {
      SteadyState<dim> &steady = kept.front().steady;
      const auto        start  = [&]() {
        steady.state = initial_state(steady.problem, wanted.patch);
      };
      if (!steady.solver.converged)
        start();
      solve_on_kept_bodies(scene, steady);
      if (!steady.solver.converged)
        {
          start();
          solve_on_kept_bodies(scene, steady);
        }
    }

    template <int dim>
    void Bodies<dim>::solve(const Situation &scene, const std::string &bodies)
    {
      const WantedMesh wanted = wanted_mesh(scene);
      problem                 = nullptr;
      if (!find(bodies, wanted))
        make(scene,
             bodies,
             wanted,
             {},
             kept.empty()
               ? "the first state"
               : "no bodies that are kept are made for " + bodies +
                   " and a patch of " +
                   significant(wanted.patch.half_width_x, 3) +
                   " m half-width, " +
                   significant(wanted.patch.half_width_y, 3) + " m across");
      else
        {
          std::string why = "the patch is elsewhere than in the zone of nodes";
          if (kept.front().reaches(wanted))
            {
              solve_kept(scene, wanted);
              const SteadyState<dim> &steady = kept.front().steady;
              why = steady.solver.converged && zone_too_small(steady)
                      ? "the patch reaches the border of the candidate zone"
                      : "";
            }
          if (!why.empty())
            {
              const std::vector<ZoneBox> patches = kept.front().patches;
              kept.pop_front();
              make(scene, bodies, wanted, patches, why);
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
