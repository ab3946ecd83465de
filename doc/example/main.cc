#include <rolling_contact/scene/situation.h>
#include <rolling_contact/state/state_finder.h>
#include <rolling_contact/tables/quiet_context.h>

#include <cstdio>

// Two cylinders of steel, radius 0.46 m, pressed together by 0.22 mm and
// rolling at a creepage of 0.17 %.
int main()
{
  using namespace RollingContact;
  SceneParameters scene;
  scene.contact.approach           = 0.22e-3;
  scene.contact.creepages.x        = 0.0017;
  scene.mesh.elements_across_patch = 48;
  scene.check();

  QuietContext context;

  const SteadyState<2> steady =
    solve_steady_state<2>(Situation(scene), StateDemands(), context.run);
  const Resultants &result = steady.result;
  std::printf("N = %.1f N, T = %.1f N, half-width %.4f mm, converged %d\n",
              result.normal_force,
              result.force_x,
              1e3 * result.half_width_x,
              steady.solver.converged);
}
