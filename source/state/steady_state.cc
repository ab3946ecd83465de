#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/parallel/interrupt.h>
#include <rolling_contact/state/steady_state.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  StateDemands
  demands_in_time(const PairDemands &pair)
  {
    StateDemands demands;
    demands.pair                  = pair;
    demands.pair.surfaces_in_time = true;
    demands.zone                  = 1.5;
    demands.margin                = 3.;
    demands.one_direction         = false;
    demands.rough_responses       = false;
    return demands;
  }



  ContactState
  initial_state(const ContactProblem &problem, const PatchEstimate &patch)
  {
    ContactState state = open_state(problem);
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      {
        const auto &at = problem.operators.positions()[i];
        if (patch.contains(at[0], at[1]))
          state.pressure[i] = 1.;
      }
    return state;
  }



  namespace
  {
    /**
     * Offset in elements that puts the leading edge where `upwind 2` has no
     * first-order force error, upstream of the first contact node.
     */
    const double aligned_distance = 0.38;



    /**
     * Offset that leaves the found leading edge aligned_distance elements
     * upstream of a node.
     */
    template <int dim>
    double
    aligned_offset(const SteadyState<dim> &steady, const int flow)
    {
      const double edge =
        flow > 0 ? steady.result.edge_begin_x : steady.result.edge_end_x;
      const double shift =
        edge / steady.grading.element_size_x + flow * aligned_distance;
      return shift - std::round(shift);
    }
  } // namespace



  template <int dim>
  SteadyState<dim>
  solve_on(const SceneParameters                                     &scene,
           const StateDemands                                        &demands,
           const Grading<dim>                                        &grading,
           const std::function<ContactState(const ContactProblem &)> &start,
           RunContext                                                &context,
           const PairMaker<dim>                                      &make_pair)
  {
    throw_if_interrupted();
    const Stopwatch  watch;
    SteadyState<dim> steady;
    steady.grading = grading;
    {
      PhaseTimer::Scope phase(context.timer, Phase::mesh);
      steady.pair =
        make_pair
          ? make_pair(scene, grading)
          : std::make_shared<RollingPair<dim>>(scene, grading, demands.pair);
    }
    {
      PhaseTimer::Scope phase(context.timer, Phase::condensation);
      steady.problem = steady.pair->contact_problem(scene.contact);
    }
    PhaseTimer::Scope phase(context.timer, Phase::contact_solve);
    steady.state = start(steady.problem);
    solve_contact(scene, demands, steady);
    steady.result = resultants(steady.problem, steady.state);
    steady.wall_s = watch.seconds();
    return steady;
  }



  namespace
  {
    /**
     * A mesh for a patch that was only estimated, made anew as long as the
     * states on it ask for another one.
     */
    template <int dim>
    class FittedMesh
    {
    public:
      FittedMesh(const SceneParameters &scene,
                 const StateDemands    &demands,
                 Log                   &log)
        : scene(scene)
        , demands(demands)
        , log(log)
        , patch(estimate_patch(scene))
        , offset(scene.mesh.offset())
        , is_aligned(!scene.mesh.aligned())
      {
        grade();
      }

      /**
       * True if it fits the patch of the state; otherwise changed.
       */
      bool
      fits(const SteadyState<dim> &steady)
      {
        return !steady.solver.converged || // its patch means nothing
               (!enlarge_for(steady) && !resize_for(steady) &&
                !align_for(steady));
      }

      const SceneParameters &scene;
      const StateDemands    &demands;
      Log                   &log;
      PatchEstimate          patch;
      Grading<dim>           grading;

    private:
      void
      grade()
      {
        grading = make_grading<dim>(
          scene, demands, patch, scene.mesh.elements_across_patch, offset);
        grading.enlarge_zone(enlargement);
      }

      bool
      enlarge_for(const SteadyState<dim> &steady);

      bool
      resize_for(const SteadyState<dim> &steady);

      bool
      align_for(const SteadyState<dim> &steady);

      double       offset; ///< in elements
      bool         is_enlarged = false, is_resized = false, is_aligned;
      unsigned int enlargement = 0; ///< of the zone, in elements
    };



    template <int dim>
    bool
    FittedMesh<dim>::enlarge_for(const SteadyState<dim> &steady)
    {
      if (!zone_too_small(steady))
        return false;
      // a zone a little too small needs no larger elements
      if (is_enlarged && patch.boxes.empty())
        {
          patch.half_width_x *= 1.5;
          patch.half_width_y *= 1.5;
          is_aligned = !scene.mesh.aligned(); // for the new elements
        }
      enlargement = is_enlarged && !patch.boxes.empty() ? 2 * enlargement : 1;
      is_enlarged = true;
      grade();
      log.message("The patch reaches the border of the candidate zone; the "
                  "zone is enlarged to " +
                  significant(grading.zone_x, 3) + " m on both sides.");
      return true;
    }



    template <int dim>
    bool
    FittedMesh<dim>::resize_for(const SteadyState<dim> &steady)
    {
      const Resultants &result = steady.result;
      const double load = steady.problem.operators.load(steady.state.pressure),
                   mismatch = patch.boxes.empty()
                                ? result.half_width_x / patch.half_width_x
                                : std::cbrt(load / patch.normal_force);
      // lines of one touching node have no length
      if (is_resized || result.n_touching <= 5 || !(mismatch > 0.) ||
          (mismatch >= 0.8 && mismatch <= 1.2))
        return false;
      log.message("The patch is " + significant(mismatch, 3) +
                  " times as long as estimated: the mesh is made again for "
                  "it.");
      if (!patch.boxes.empty())
        patch = estimate_patch(scene, load);
      else
        {
          patch.half_width_x = result.half_width_x;
          if (dim == 3)
            patch.half_width_y = result.half_width_y;
        }
      grade();
      is_resized = true;
      is_aligned = !scene.mesh.aligned();
      return true;
    }



    template <int dim>
    bool
    FittedMesh<dim>::align_for(const SteadyState<dim> &steady)
    {
      if (is_aligned || steady.result.n_touching <= 5)
        return false;
      offset     = aligned_offset(steady, scene.contact.flow());
      is_aligned = true;
      grade();
      return true;
    }
  } // namespace



  template <int dim>
  SteadyState<dim>
  solve_steady_state(const SceneParameters &scene,
                     const StateDemands    &demands,
                     RunContext            &context,
                     const PairMaker<dim>  &make_pair)
  {
    const Stopwatch    watch;
    const unsigned int max_meshes = 10;
    FittedMesh<dim>    mesh(scene, demands, context.log);
    for (unsigned int k = 0; k < max_meshes; ++k)
      {
        const PatchEstimate patch  = mesh.patch;
        SteadyState<dim>    steady = solve_on<dim>(
          scene,
          demands,
          mesh.grading,
          [&](const ContactProblem &problem) {
            return initial_state(problem, patch);
          },
          context,
          make_pair);
        if (!mesh.fits(steady))
          continue;
        if (steady.solver.converged)
          steady.wall_s = watch.seconds();
        return steady;
      }
    throw ConvergenceError(
      "No mesh fits the patch, which reached the border of the candidate zone "
      "or the estimated size in " +
      std::to_string(max_meshes) +
      " attempts: check radii, load and Mesh/Candidate zone.");
  }



  std::string
  shortfall(const SolverReport &solver, const double tolerance)
  {
    return solver.reason + ". Natural residual " +
           scientific(solver.residual.worst(), 3) + ", required " +
           scientific(tolerance, 3);
  }



  template <int dim>
  void
  require_solved(const SceneParameters  &scene,
                 const SteadyState<dim> &steady,
                 const std::string      &where)
  {
    if (!steady.solver.converged)
      throw ConvergenceError(
        where + ": " +
        shortfall(steady.solver, scene.solver.controls.tolerance) + ".");
    if (zone_too_small(steady))
      throw ConvergenceError(where +
                             ": the patch reaches the border of the candidate "
                             "zone. Take a larger Mesh/Candidate zone.");
  }



  template struct SteadyState<2>;
  template SteadyState<2>
  solve_on(const SceneParameters &,
           const StateDemands &,
           const Grading<2> &,
           const std::function<ContactState(const ContactProblem &)> &,
           RunContext &,
           const PairMaker<2> &);
  template SteadyState<3>
  solve_on(const SceneParameters &,
           const StateDemands &,
           const Grading<3> &,
           const std::function<ContactState(const ContactProblem &)> &,
           RunContext &,
           const PairMaker<3> &);
  template SteadyState<2>
  solve_steady_state(const SceneParameters &,
                     const StateDemands &,
                     RunContext &,
                     const PairMaker<2> &);
  template struct SteadyState<3>;
  template SteadyState<3>
  solve_steady_state(const SceneParameters &,
                     const StateDemands &,
                     RunContext &,
                     const PairMaker<3> &);
  template void
  require_solved(const SceneParameters &,
                 const SteadyState<2> &,
                 const std::string &);
  template void
  require_solved(const SceneParameters &,
                 const SteadyState<3> &,
                 const std::string &);
} // namespace RollingContact
