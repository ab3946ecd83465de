#include <rolling_contact/base/text.h>
#include <rolling_contact/pair/friction_heat.h>
#include <rolling_contact/solvers/compliance_update.h>
#include <rolling_contact/solvers/force_control.h>
#include <rolling_contact/state/steady_state.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    template <int dim>
    void solve_once(const PairSpec     &scene,
                    const StateDemands &demands,
                    SteadyState<dim>   &steady)
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
     * With mu of each node as the temperature there has it, which friction
     * makes: where it is hotter there is less friction, if mu falls, and less
     * heat, so that rounds approach each other; half the way where they do not.
     */
    template <int dim>
    void solve_hot(const HotFriction  &law,
                   const PairSpec     &scene,
                   const StateDemands &demands,
                   SteadyState<dim>   &steady)
    {
      const double       settled     = 1e-9;
      const unsigned int most_rounds = 60, n_whole = 20;
      const auto   cold     = steady.pair->friction_at_nodes(scene.contact, 0.);
      auto        &friction = steady.problem.loads.friction;
      SolverReport rounds;
      for (unsigned int k = 0; k < most_rounds && !rounds.converged; ++k)
        {
          solve_once(scene, demands, steady);
          rounds.add_friction_round(steady.solver);
          if (!steady.solver.converged)
            break;
          const auto hot    = hot_friction(scene,
                                        law,
                                        cold,
                                        flash_temperature(scene,
                                                          steady.problem,
                                                          steady.state));
          double     change = 0.;
          for (std::size_t i = 0; i < hot.size(); ++i)
            change = std::max(change, std::abs(hot[i] - friction[i]));
          rounds.converged =
            change <= settled * scene.contact.friction_coefficient;
          if (rounds.converged)
            break;
          for (std::size_t i = 0; i < hot.size(); ++i)
            friction[i] += (k < n_whole ? 1. : 0.5) * (hot[i] - friction[i]);
        }
      if (!rounds.converged && steady.solver.converged)
        rounds.reason = "friction and the temperature of the surfaces did not "
                        "settle: Contact/Friction over temperature may change "
                        "too steeply";
      steady.solver = rounds;
    }

    /**
     * A solve at constant mu, or rounds of them where mu follows the heat.
     */
    template <int dim>
    void solve_with_friction(const PairSpec     &scene,
                             const StateDemands &demands,
                             SteadyState<dim>   &steady)
    {
      const HotFriction law(scene.contact.friction_over_temperature);
      law.is_constant() || steady.problem.n_tangential() == 0
        ? solve_once(scene, demands, steady)
        : solve_hot(law, scene, demands, steady);
    }

    /**
     * The load of the pressure by secants between those that gave too little
     * and too much: the force of friction changes little with it. On a mesh it
     * may jump where an edge passes a node, so bisections end the search, at
     * the load or at a jump beyond which it lies.
     */
    template <int dim>
    void solve_inclined(const PairSpec     &scene,
                        const StateDemands &demands,
                        SteadyState<dim>   &steady)
    {
      const InclinedLoad asked = *steady.problem.loads.inclined_load;
      const double cosine = std::cos(asked.angle), sine = std::sin(asked.angle),
                   first_slope =
                     std::cos(asked.angle -
                              steady.problem.operators.frames().load_angle),
                   accuracy         = 1e-10;
      const unsigned int max_rounds = 40, n_secants = 10;
      double            &load     = *steady.problem.loads.normal_load;
      double             old_load = 0., old_excess = -asked.load;
      double             too_little = 0.,
             too_much               = std::numeric_limits<double>::infinity();
      for (unsigned int k = 0; k < max_rounds; ++k)
        {
          solve_with_friction(scene, demands, steady);
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
          (excess < 0. ? too_little : too_much) = load;
          const double most = 2., next = load - excess / slope;
          load = slope > 0. && next > load / most && next < load * most
                   ? next
                   : load - excess / first_slope;
          if (too_little < too_much && std::isfinite(too_much) &&
              (k >= n_secants || load <= too_little || load >= too_much))
            load = (too_little + too_much) / 2;
        }
      const bool jumps        = std::abs(too_much - too_little) < 1e-6 * load;
      steady.solver.converged = false;
      const bool        is_vertical = scene.contact.vertical_load.has_value();
      const std::string other =
        is_vertical ? "Contact/Normal load" : "Contact/Approach";
      steady.solver.reason =
        (is_vertical ? "Contact/Vertical load = " : "Contact/Normal load = ") +
        significant(asked.load, 6) + " N " +
        (jumps ? "is not reached: on this mesh friction changes by a jump "
                 "where pressure alone gives " +
                   significant(load, 6) +
                   " N, and the load jumps over the one "
                   "that is asked for. Give " +
                   other + ", or change Mesh/Elements across patch"
               : "was not found together with friction in " +
                   std::to_string(max_rounds) + " rounds. Give " + other);
    }
  } // namespace

  template <int dim>
  void solve_contact(const PairSpec     &scene,
                     const StateDemands &demands,
                     SteadyState<dim>   &steady)
  {
    const auto solve = [&]() {
      steady.problem.loads.inclined_load
        ? solve_inclined(scene, demands, steady)
        : solve_with_friction(scene, demands, steady);
      return steady.solver;
    };
    if (!steady.problem.loads.forces.any())
      {
        steady.solver = solve();
        return;
      }
    // friction on a patch that its zone cuts off is not that of the whole: the
    // search ends, and whoever finds the zone too small makes a larger one
    bool       is_cut        = false;
    const auto solve_in_zone = [&]() {
      SolverReport report = solve();
      is_cut              = report.converged && zone_too_small(steady);
      report.converged    = report.converged && !is_cut;
      return report;
    };
    steady.solver = solve_for_forces(solve_in_zone,
                                     scene.solver.controls,
                                     steady.problem,
                                     steady.state);
    if (is_cut)
      steady.solver.converged = true;
  }

  template void
  solve_contact(const PairSpec &, const StateDemands &, SteadyState<2> &);
  template void
  solve_contact(const PairSpec &, const StateDemands &, SteadyState<3> &);
} // namespace RollingContact
