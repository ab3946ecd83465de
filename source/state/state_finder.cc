#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/contact/patch_edges.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/pair/split_choice.h>
#include <rolling_contact/state/state_finder.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  template <int dim>
  void say_enlarged(const Grading<dim> &grading, Log &log)
  {
    log.message("The patch reaches the border of the candidate zone; the zone "
                "is enlarged to " +
                significant(grading.zone_x, 3) + " m on both sides.");
  }

  namespace
  {
    /**
     * Offset in elements that puts the leading edge, as extrapolated, where
     * `upwind 2` has no first-order force error, upstream of the first contact
     * node.
     */
    const double aligned_distance = 0.38;

    /// so many touching nodes tell less of a patch than their load does; where
    /// fewer elements than these are wanted across it they tell nothing
    const unsigned int few_nodes = 5, few_elements = 6;

    /**
     * Offset that leaves the found leading edge aligned_distance elements
     * upstream of a node.
     */
    template <int dim>
    double aligned_offset(const SteadyState<dim> &steady, const int flow)
    {
      const PatchEdges edges =
        extrapolated_edges(steady.problem.operators, steady.state.pressure);
      const double edge = flow > 0 ? edges.begin_x : edges.end_x;
      const double shift =
        edge / steady.grading.element_size_x + flow * aligned_distance;
      return shift - std::round(shift);
    }

    [[noreturn]] void throw_unenclosed(const std::string &where)
    {
      throw ConvergenceError(
        where +
        "No mesh fits the patch, which reached the border of the candidate "
        "zone or the estimated size in " +
        std::to_string(most_meshes) +
        " attempts: check radii, load and Mesh/Candidate zone.");
    }
  } // namespace

  /**
   * A mesh for a patch that was only estimated, made anew as long as the
   * states on it ask for another one.
   */
  template <int dim>
  class FittedMesh
  {
  public:
    FittedMesh(const PairSpec &scene, const StateDemands &demands, Log &log)
      : scene(scene)
      , demands(demands)
      , log(log)
      , patch(demands.patch ? *demands.patch : estimate_patch(scene))
      , offset(scene.mesh.offset())
      , is_aligned(!scene.mesh.aligned())
    {
      grade();
    }

    /**
     * True if it fits the patch of the state; otherwise changed.
     */
    bool fits(const SteadyState<dim> &steady)
    {
      return !steady.solver.converged || // its patch means nothing
             (!enlarge_for(steady) && !resize_for(steady) &&
              !align_for(steady));
    }

    /** Tell if the patch has fewer elements than were asked for. */
    void warn_of_few(const SteadyState<dim> &steady) const;

    const PairSpec     &scene;
    const StateDemands &demands;
    Log                &log;
    PatchEstimate       patch;
    Grading<dim>        grading;

  private:
    void grade()
    {
      grading = make_grading<dim>(
        scene, demands, patch, scene.mesh.elements_across_patch, offset);
      grading.enlarge_zone(enlargement);
      if (!is_at_side)
        end_at_side(scene, patch.half_width_y, grading);
    }

    bool enlarge_for(const SteadyState<dim> &steady);

    bool resize_for(const SteadyState<dim> &steady);

    bool align_for(const SteadyState<dim> &steady);

    double       offset; ///< in elements
    bool         is_aligned;
    bool         is_at_side  = false; ///< of a body
    bool         is_grown    = false; ///< by more than the zone's elements
    unsigned int n_resized   = 0;
    unsigned int enlargement = 0; ///< of the zone, in elements
    unsigned int n_around    = 1; ///< elements, at places that are reached
  };

  template <int dim>
  bool FittedMesh<dim>::enlarge_for(const SteadyState<dim> &steady)
  {
    if (!zone_too_small(steady))
      return false;
    is_at_side               = reaches_side(scene, steady);
    const unsigned int asked = scene.mesh.elements_across_patch,
                       first =
                         patch.boxes.empty() ? std::max(1u, asked / 8) : 1,
                       next = enlargement == 0 ? first : 2 * enlargement;
    // where patches are, nodes all around them would be of no use elsewhere
    if (!patch.boxes.empty() && enlargement > 0)
      {
        n_around *= 2;
        for (const unsigned int i : nodes_at_border(steady.pair->border_nodes(),
                                                    steady.problem,
                                                    steady.state.pressure))
          {
            const auto &at = steady.problem.operators.positions()[i];
            patch.boxes.push_back(ZoneBox{at, at}.grown(
              std::min(n_around * grading.element_size_x, patch.half_width_x),
              n_around * grading.element_size_y));
          }
      }
    // a zone that is a little too small needs no larger elements
    else if (patch.boxes.empty() && next > std::max(first, asked / 2))
      {
        patch.half_width_x *= 1.5;
        patch.half_width_y *= 1.5;
        is_grown   = true;
        is_aligned = !scene.mesh.aligned(); // for the new elements
      }
    else
      enlargement = next;
    grade();
    say_enlarged(grading, log);
    return true;
  }

  template <int dim>
  bool FittedMesh<dim>::resize_for(const SteadyState<dim> &steady)
  {
    const unsigned int most_times = is_grown ? 1 : 4;
    const Resultants  &result     = steady.result;
    const double load = steady.problem.operators.load(steady.state.pressure);
    // of few elements a few nodes are no measure of the patch
    const bool too_few = result.n_touching <= few_nodes &&
                         scene.mesh.elements_across_patch < few_elements;
    if (too_few || n_resized >= most_times || result.n_touching == 0 ||
        !(load > 0.))
      return false;
    // what few nodes tell of a patch is less than what their load does
    const bool by_load = !patch.boxes.empty() || result.n_touching <= few_nodes;
    const auto estimate_again = [&]() {
      if (by_load)
        return estimate_patch(scene, load);
      PatchEstimate measured = patch;
      measured.half_width_x  = result.half_width_x;
      if (dim == 3)
        measured.half_width_y = result.half_width_y;
      return measured;
    };
    // an estimate on profiles costs as much as a state
    const double mismatch =
      patch.boxes.empty() ? estimate_again().half_width_x / patch.half_width_x
                          : std::cbrt(load / patch.normal_force);
    if (!(mismatch > 0.) || (mismatch >= 0.8 && mismatch <= 1.2))
      return false;
    log.message("The patch is " + significant(mismatch, 3) +
                " times as long as estimated: the mesh is made again for "
                "it.");
    patch = estimate_again();
    grade();
    ++n_resized;
    is_aligned = !scene.mesh.aligned();
    return true;
  }

  template <int dim>
  void FittedMesh<dim>::warn_of_few(const SteadyState<dim> &steady) const
  {
    const unsigned int asked = scene.mesh.elements_across_patch;
    const double made = 2 * steady.result.half_width_x / grading.element_size_x;
    // on profiles the line that was measured may not be the longest
    if (patch.boxes.empty() && steady.solver.converged &&
        steady.result.n_touching > 0 && made < 0.8 * asked)
      log.warning("Mesh/Elements across patch = " + std::to_string(asked) +
                  ": " + significant(made, 2) +
                  " are across the patch, which is shorter than estimated; "
                  "take more of them" +
                  (scene.contact.approach
                     ? ", or give Contact/Normal load in place of an approach."
                     : "."));
  }

  template <int dim>
  bool FittedMesh<dim>::align_for(const SteadyState<dim> &steady)
  {
    if (is_aligned || steady.result.n_touching <= 5)
      return false;
    offset     = aligned_offset(steady, scene.contact.flow());
    is_aligned = true;
    grade();
    return true;
  }

  namespace
  {
    /**
     * Meshes and bodies of this size take seconds, so that it is said what is
     * done.
     */
    const double      many_cells    = 20000.;
    const std::size_t many_unknowns = 60000;
  } // namespace

  template <int dim>
  SteadyState<dim> StateFinder<dim>::set_up(const Grading<dim> &grading) const
  {
    SteadyState<dim> steady;
    steady.grading = grading;
    {
      PhaseTimer::Scope phase(context.timer, Phase::mesh);
      if (!make_pair && !choose_compliance(scene, grading, demands.pair).split)
        if (const CellCount cells = cells_to_mesh(scene, grading);
            cells.total > many_cells)
          context.log.message("Meshing " + cells.text + ".");
      steady.pair =
        make_pair
          ? make_pair(scene, grading)
          : std::make_shared<RollingPair<dim>>(scene, grading, demands.pair);
    }
    PhaseTimer::Scope phase(context.timer, Phase::condensation);
    const std::size_t n_unknowns = steady.pair->bodies().n_unknowns();
    if (!make_pair && n_unknowns > many_unknowns)
      context.log.message(
        "Condensing bodies of " + std::to_string(n_unknowns) + " unknowns to " +
        std::to_string(steady.pair->trace().nodes.size()) + " contact nodes.");
    steady.problem = steady.pair->contact_problem(scene.contact);
    return steady;
  }

  template <int dim>
  SteadyState<dim> StateFinder<dim>::solve_on(const Grading<dim> &grading,
                                              const Start        &start) const
  {
    throw_if_interrupted();
    const Stopwatch   watch;
    SteadyState<dim>  steady = set_up(grading);
    PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
    steady.state = start(steady.problem);
    solve_contact(scene, demands, steady);
    steady.result = resultants(steady.problem, steady.state);
    steady.wall_s = watch.seconds();
    return steady;
  }

  template <int dim>
  SteadyState<dim> StateFinder<dim>::find() const
  {
    const Stopwatch  watch;
    FittedMesh<dim>  mesh(scene, demands, context.log);
    SteadyState<dim> steady;
    if (!solve_on_fitting_mesh(
          [&](const unsigned int) {
            steady = {}; // its bodies go before there are others
            steady = solve_on(mesh.grading, [&](const ContactProblem &problem) {
              return initial_state(problem, mesh.patch);
            });
          },
          [&](const unsigned int) { return !mesh.fits(steady); }))
      throw_unenclosed("");
    mesh.warn_of_few(steady);
    if (steady.solver.converged)
      steady.wall_s = watch.seconds();
    return steady;
  }

  template <int dim>
  SteadyState<dim> StateFinder<dim>::find_from(const SteadyState<dim> &previous,
                                               Grading<dim>            grading,
                                               const std::string &where) const
  {
    SteadyState<dim> steady;
    if (!solve_on_fitting_mesh(
          [&](const unsigned int) {
            steady = {};
            steady = solve_on(grading, [&](const ContactProblem &problem) {
              return transferred_state(previous, problem);
            });
          },
          [&](const unsigned int k) {
            return enlarge_zone(steady, k, grading);
          }))
      throw_unenclosed(where + ". ");
    return steady;
  }

  template <int dim>
  void StateFinder<dim>::solve_enclosed(SteadyState<dim> &steady) const
  {
    Grading<dim> grading = steady.grading;
    solve_on_fitting_mesh(
      [&](const unsigned int k) {
        if (k > 0)
          {
            steady.pair->release_statics();
            SteadyState<dim> next = set_up(grading);
            next.level            = steady.level;
            next.change           = steady.change;
            next.limit            = steady.limit;
            ContactLoads &loads   = next.problem.loads;
            loads.normal_load     = steady.problem.loads.normal_load;
            loads.approach        = steady.problem.loads.approach;
            loads.inclined_load   = steady.problem.loads.inclined_load;
            loads.creepages       = steady.problem.loads.creepages;
            loads.forces          = steady.problem.loads.forces;
            next.state            = transferred_state(steady, next.problem);
            steady                = std::move(next);
          }
        PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
        solve_contact(scene, demands, steady);
        steady.result = resultants(steady.problem, steady.state);
      },
      [&](const unsigned int k) { return enlarge_zone(steady, k, grading); });
  }

  template <int dim>
  bool StateFinder<dim>::enlarge_zone(const SteadyState<dim> &steady,
                                      const unsigned int      k,
                                      Grading<dim>           &grading) const
  {
    // the patch of a state that is none means nothing
    if (!steady.solver.converged || !zone_too_small(steady))
      return false;
    RollingContact::enlarge_zone(scene, steady, 1u << k, grading);
    say_enlarged(grading, context.log);
    return true;
  }

  template class StateFinder<2>;
  template class StateFinder<3>;
  template void say_enlarged(const Grading<2> &, Log &);
  template void say_enlarged(const Grading<3> &, Log &);
} // namespace RollingContact
