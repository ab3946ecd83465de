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
    demands.pair            = pair;
    demands.zone            = 1.5;
    demands.margin          = 3.;
    demands.one_direction   = false;
    demands.rough_responses = false;
    return demands;
  }



  namespace
  {
    /**
     * As many as along x, but on a patch that is slender along x fewer: long
     * thin elements make tractions worse; and of the same size as along x on
     * patches of profiles that are wider, as their pressure varies across more
     * than that of an ellipse.
     */
    unsigned int
    elements_across_y(const PatchEstimate &patch,
                      const unsigned int   elements_across_patch)
    {
      const double       longest = 1.9; // over the width of an element
      const unsigned int least   = 6;
      const double       enough  = std::floor(longest * elements_across_patch *
                                       patch.half_width_y / patch.half_width_x);
      if (!patch.boxes.empty() && patch.half_width_y > patch.half_width_x)
        return std::ceil(elements_across_patch * patch.half_width_y /
                         patch.half_width_x);
      return std::min<unsigned int>(elements_across_patch,
                                    std::max<double>(least, enough));
    }



    /**
     * The boxes of the patch in place of its ellipse, with as much around them.
     */
    template <int dim>
    void
    set_zone_boxes(const PatchEstimate &patch, Grading<dim> &grading)
    {
      const double around_x = grading.zone_x - patch.half_width_x,
                   around_y = grading.zone_y - patch.half_width_y,
                   upstream = grading.element_size_x;
      grading.zone_x = grading.zone_y = 0.;
      for (const ZoneBox &touching : patch.boxes)
        {
          ZoneBox box = touching.grown(around_x, around_y);
          if (grading.upstream < 0)
            box.lower[0] -= upstream;
          if (grading.upstream > 0)
            box.upper[0] += upstream;
          grading.zone_boxes.push_back(box);
          for (const auto &corner : {box.lower, box.upper})
            {
              grading.zone_x = std::max(grading.zone_x, std::abs(corner[0]));
              grading.zone_y = std::max(grading.zone_y, std::abs(corner[1]));
            }
        }
      grading.upstream = 0;
    }
  } // namespace



  template <int dim>
  Grading<dim>
  make_grading(const SceneParameters &scene,
               const StateDemands    &demands,
               const PatchEstimate   &patch,
               const unsigned int     elements_across_patch,
               const double           offset)
  {
    const MeshParameters &mesh = scene.mesh;
    Grading<dim>          grading;
    const unsigned int    elements_y =
      mesh.elements_across_patch_y > 0
           ? mesh.elements_across_patch_y
           : elements_across_y(patch, elements_across_patch);
    const double factor =
      mesh.candidate_zone > 0. ? mesh.candidate_zone : demands.zone;
    const auto zone = [&](const double half_width, const double size) {
      return std::max(factor * demands.growth * half_width,
                      demands.growth * half_width + demands.margin * size);
    };
    const double half_width = patch.half_width_x;
    grading.element_size_x  = 2 * half_width / elements_across_patch;
    grading.element_size_y  = 2 * patch.half_width_y / elements_y;
    grading.zone_x          = zone(half_width, grading.element_size_x);
    grading.upstream        = demands.one_direction ? -scene.contact.flow() : 0;
    grading.zone_y          = zone(patch.half_width_y, grading.element_size_y);
    grading.zone_depth      = mesh.zone_depth * half_width *
                         grading.element_size_z() / grading.element_size_x;
    grading.growth            = mesh.growth;
    grading.offset            = offset;
    grading.rim_levels        = mesh.rim_levels;
    grading.leading_edge_x    = -scene.contact.flow() * half_width;
    grading.trailing_edge_x   = -grading.leading_edge_x;
    grading.leading_edge_only = mesh.rim_edges == RimEdges::leading;
    grading.rim_width         = 2 * grading.element_size_x;
    if (!patch.boxes.empty())
      set_zone_boxes(patch, grading);
    return grading;
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
           RunContext                                                &context)
  {
    throw_if_interrupted();
    const Stopwatch  watch;
    SteadyState<dim> steady;
    steady.grading = grading;
    {
      PhaseTimer::Scope phase(context.timer, Phase::mesh);
      steady.pair =
        std::make_unique<RollingPair<dim>>(scene, grading, demands.pair);
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
      const double      mismatch =
        patch.boxes.empty()
               ? result.half_width_x / patch.half_width_x
               : std::cbrt(result.normal_force / patch.normal_force);
      if (is_resized || result.n_touching <= 5 ||
          (mismatch >= 0.8 && mismatch <= 1.2))
        return false;
      log.message("The patch is " + significant(mismatch, 3) +
                  " times as long as estimated: the mesh is made again for "
                  "it.");
      if (!patch.boxes.empty())
        patch = estimate_patch(scene, result.normal_force);
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
                     RunContext            &context)
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
          context);
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
  template Grading<2>
  make_grading(const SceneParameters &,
               const StateDemands &,
               const PatchEstimate &,
               const unsigned int,
               const double);
  template SteadyState<2>
  solve_on(const SceneParameters &,
           const StateDemands &,
           const Grading<2> &,
           const std::function<ContactState(const ContactProblem &)> &,
           RunContext &);
  template SteadyState<3>
  solve_on(const SceneParameters &,
           const StateDemands &,
           const Grading<3> &,
           const std::function<ContactState(const ContactProblem &)> &,
           RunContext &);
  template SteadyState<2>
  solve_steady_state(const SceneParameters &,
                     const StateDemands &,
                     RunContext &);
  template struct SteadyState<3>;
  template Grading<3>
  make_grading(const SceneParameters &,
               const StateDemands &,
               const PatchEstimate &,
               const unsigned int,
               const double);
  template SteadyState<3>
  solve_steady_state(const SceneParameters &,
                     const StateDemands &,
                     RunContext &);
  template void
  require_solved(const SceneParameters &,
                 const SteadyState<2> &,
                 const std::string &);
  template void
  require_solved(const SceneParameters &,
                 const SteadyState<3> &,
                 const std::string &);
} // namespace RollingContact
