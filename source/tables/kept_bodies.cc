#include <rolling_contact/base/stopwatch.h>
#include <rolling_contact/pair/mesh_limits.h>
#include <rolling_contact/tables/kept_bodies.h>

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

  template void solve_on_kept_bodies(const PairSpec &, SteadyState<2> &);
  template void solve_on_kept_bodies(const PairSpec &, SteadyState<3> &);
} // namespace RollingContact
