#include <rolling_contact/base/stopwatch.h>
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
    steady.pair->set_loads(scene.contact, steady.problem);
    solve_contact(scene, demands_of_kept_bodies(), steady);
    steady.result = resultants(steady.problem, steady.state);
    steady.wall_s = watch.seconds();
  }

  double patch_size(const PairSpec &scene)
  {
    return bodies_touch(scene) ? estimate_patch(scene).half_width_x : 0.;
  }

  template void solve_on_kept_bodies(const PairSpec &, SteadyState<2> &);
  template void solve_on_kept_bodies(const PairSpec &, SteadyState<3> &);
} // namespace RollingContact
