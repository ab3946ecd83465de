#include <rolling_contact/pair/compliance_update.h>
#include <rolling_contact/state/steady_state.h>

#include <cmath>

namespace RollingContact
{
  namespace
  {
    template <int dim>
    void
    solve_once(const SceneParameters &scene,
               const StateDemands    &demands,
               SteadyState<dim>      &steady)
    {
      steady.solver = solve_updating_compliance(
        *make_contact_solver(scene.solver.solver, scene.solver.controls),
        [&](const auto &forces, const bool roughly) {
          return steady.pair->response(forces,
                                       roughly && demands.rough_responses);
        },
        steady.pair->compliance_is_exact(),
        scene.solver.controls,
        steady.problem,
        steady.state);
    }



    /**
     * The load of the pressure by secants: the force of friction changes little
     * with it.
     */
    template <int dim>
    void
    solve_inclined(const SceneParameters &scene,
                   const StateDemands    &demands,
                   SteadyState<dim>      &steady)
    {
      const InclinedLoad asked = *steady.problem.loads.inclined_load;
      const double cosine = std::cos(asked.angle), sine = std::sin(asked.angle),
                   first_slope =
                     std::cos(asked.angle -
                              steady.problem.operators.frames().load_angle),
                   accuracy         = 1e-10;
      const unsigned int max_rounds = 30;
      double            &load       = *steady.problem.loads.normal_load;
      double             old_load = 0., old_excess = -asked.load;
      for (unsigned int k = 0; k < max_rounds; ++k)
        {
          solve_once(scene, demands, steady);
          if (!steady.solver.converged)
            return;
          const Resultants found = resultants(steady.problem, steady.state);
          const double     excess =
            found.normal_force * cosine - found.force_y * sine - asked.load;
          if (std::abs(excess) <= accuracy * asked.load)
            return;
          const double slope = (excess - old_excess) / (load - old_load);
          old_load           = load;
          old_excess         = excess;
          const double most = 2., next = load - excess / slope;
          load = slope > 0. && next > load / most && next < load * most
                   ? next
                   : load - excess / first_slope;
        }
      steady.solver.converged = false;
      steady.solver.reason =
        "The normal load that with friction gives Contact/Vertical load was "
        "not found in " +
        std::to_string(max_rounds) + " rounds";
    }
  } // namespace



  template <int dim>
  void
  solve_contact(const SceneParameters &scene,
                const StateDemands    &demands,
                SteadyState<dim>      &steady)
  {
    steady.problem.loads.inclined_load ? solve_inclined(scene, demands, steady)
                                       : solve_once(scene, demands, steady);
  }



  template void
  solve_contact(const SceneParameters &,
                const StateDemands &,
                SteadyState<2> &);
  template void
  solve_contact(const SceneParameters &,
                const StateDemands &,
                SteadyState<3> &);
} // namespace RollingContact
