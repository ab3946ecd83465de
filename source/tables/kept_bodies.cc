#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/tables/kept_bodies.h>

#include <algorithm>
#include <cmath>

namespace RollingContact
{
  StateDemands demands_of_kept_bodies()
  {
    StateDemands demands;
    demands.pair.factors     = true;
    demands.pair.bulk_errors = true;
    return demands;
  }

  void take_economical_solver(PairSpec &scene)
  {
    if (scene.solver.solver == "automatic")
      scene.solver.solver = "economical";
  }

  template <int dim>
  void solve_on_kept_bodies(const PairSpec &scene, SteadyState<dim> &steady)
  {
    const Stopwatch watch;
    PairSpec        placed = scene;
    if (scene.follows_profiles())
      placed.frame = steady.pair->frame();
    if (!steady.pair->is_placed_as(placed))
      {
        steady.pair = std::make_shared<RollingPair<dim>>(placed, *steady.pair);
        steady.pair->set_surfaces(steady.problem);
      }
    // creepages of a search that found nothing are no place to begin at
    if (!steady.solver.converged)
      steady.problem.loads.forces = AskedForces();
    steady.solver.converged = false; // where it throws
    steady.pair->set_loads(scene.contact, steady.problem);
    solve_contact(scene, demands_of_kept_bodies(), steady);
    steady.result = resultants(steady.problem, steady.state);
    steady.wall_s = watch.seconds();
  }

  namespace
  {
    template <int dim>
    WantedMesh mesh_for(const PairSpec &scene, const PatchEstimate &patch)
    {
      const Grading<dim> grading =
        make_grading<dim>(scene,
                          demands_of_kept_bodies(),
                          patch,
                          scene.mesh.elements_across_patch,
                          scene.mesh.offset());
      return {patch,
              {{grading.element_size_x, grading.element_size_y}},
              contact_nodes(grading)};
    }
  } // namespace

  WantedMesh wanted_mesh(const PairSpec &scene)
  {
    if (!bodies_touch(scene))
      return {};
    return wanted_mesh(scene, estimate_patch(scene));
  }

  WantedMesh wanted_mesh(const PairSpec &scene, const PatchEstimate &patch)
  {
    return scene.dimension == 2 ? mesh_for<2>(scene, patch)
                                : mesh_for<3>(scene, patch);
  }

  template <int dim>
  double KeptBodies<dim>::misfit(const WantedMesh &wanted) const
  {
    double largest = 0.;
    for (unsigned int d = 0; d < dim - 1; ++d)
      largest =
        std::max(largest,
                 std::abs(std::log(wanted.element_size[d] / element_size[d])));
    return largest;
  }

  template <int dim>
  bool KeptBodies<dim>::suits(const WantedMesh &wanted,
                              const double      smallest) const
  {
    return misfit(wanted) <= -std::log(smallest) * (1 + 1e-9);
  }

  template <int dim>
  bool KeptBodies<dim>::reaches(const WantedMesh &wanted) const
  {
    const auto  &boxes = wanted.patch.boxes;
    const double step  = steady.grading.element_size_x / 2;
    return std::all_of(boxes.begin(), boxes.end(), [&](const ZoneBox &box) {
      return covers(steady.grading.zone_boxes, box, step) ||
             covers(patches, box, step);
    });
  }

  template <int dim>
  double KeptBodies<dim>::elements_across() const
  {
    return 2 * steady.result.half_width_x / steady.grading.element_size_x;
  }

  template <int dim>
  bool KeptBodies<dim>::serves(const PairSpec &scene,
                               const double    smallest) const
  {
    // of several patches the smallest decides on the elements
    const double asked = scene.mesh.elements_across_patch,
                 now = elements_across(), most = std::max(made, asked);
    return steady.solver.converged && !zone_too_small(steady) &&
           now >= smallest * asked && now <= most / smallest;
  }

  template <int dim>
  bool KeptBodies<dim>::solve_from_here(const PairSpec &scene, const bool holds)
  {
    steady.state.holds_scheme = holds;
    solve_on_kept_bodies(scene, steady);
    steady.state.holds_scheme = false;
    return steady.solver.converged;
  }

  template <int dim>
  KeptBodies<dim>
  KeptBodies<dim>::made_for(const PairSpec                     &scene,
                            const WantedMesh                   &wanted,
                            const std::vector<ZoneBox>         &other_patches,
                            const std::shared_ptr<SplitBodies> &split_bodies,
                            RunContext                         &context)
  {
    StateDemands demands      = demands_of_kept_bodies();
    demands.pair.split_bodies = split_bodies;
    demands.other_patches     = other_patches;
    if (wanted.patch.half_width_x > 0.)
      demands.patch = wanted.patch;
    KeptBodies found{wanted.element_size,
                     wanted.patch.boxes,
                     solve_steady_state<dim>(scene, demands, context)};
    found.steady.pair->release_statics();
    found.made = found.elements_across();
    found.patches.insert(found.patches.end(),
                         other_patches.begin(),
                         other_patches.end());
    return found;
  }

  template void solve_on_kept_bodies(const PairSpec &, SteadyState<2> &);
  template void solve_on_kept_bodies(const PairSpec &, SteadyState<3> &);

  template struct KeptBodies<2>;
  template struct KeptBodies<3>;
} // namespace RollingContact
