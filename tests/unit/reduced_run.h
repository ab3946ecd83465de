#ifndef rolling_contact_tests_reduced_run_h
#define rolling_contact_tests_reduced_run_h

#include "stability_bodies.h"

#include <rolling_contact/time/patch_friction.h>
#include <rolling_contact/vibration/reduced_motion.h>

#include <optional>

namespace StabilityBodies
{
  /**
   * A motion under contact laws, as a program takes its steps.
   */
  class Run
  {
  public:
    Run(const ReducedPair &pair, const RollingState &rolling, const double h)
      : Run(pair, rolling, h, pair)
    {}

    /** At rest in the steady state of @p resting, under its approach or under
     * its load, and with friction that falls with a @p delay. */
    Run(const ReducedPair  &pair,
        const RollingState &rolling,
        const double        h,
        const ReducedPair  &resting,
        const bool          hold  = true,
        const double        delay = 0.)
      : motion(pair)
      , problem(rolling.problem)
      , state(rolling.state)
      , h(h)
    {
      SolverControls controls;
      controls.tolerance = 1e-12;
      solver             = make_contact_solver("automatic", controls);
      gap                = problem.loads.gap;
      if (delay > 0.) // while the sliding is that of the steady state
        {
          friction.emplace(problem, state, delay);
          problem.loads.friction_law.reset();
        }
      if (hold)
        {
          problem.loads.normal_load.reset();
          problem.loads.approach = state.approach;
        }
      const auto forces = nodal_forces(problem, state);
      motion.rest_at(amplitudes(resting, forces), forces);
      set_time_step(h);
    }

    void set_time_step(const double step)
    {
      h = step;
      motion.set_time_step(h);
      problem.operators.set_compliance(motion.compliance());
      problem.operators.set_time_scaling(
        {1., ReducedMotion::velocity_factor / (h * speed)});
      problem.loads.speed = speed;
    }

    const StepEnergy &step()
    {
      motion.begin_step();
      const auto &u = motion.free_displacement(), &v = motion.free_velocity();
      const std::size_t N = problem.n_nodes(), n = u.size() - N;
      problem.loads.free_displacement =
        NodalField(N, {u.begin(), u.begin() + n});
      problem.loads.free_slip = NodalField(N, {v.begin(), v.begin() + n});
      problem.loads.free_slip *= 1 / speed;
      for (std::size_t i = 0; i < N; ++i)
        problem.loads.gap[i] = gap[i] + u[n + i];
      if (friction)
        friction->begin_step(h);
      do
        {
          if (friction)
            problem.loads.friction = friction->coefficients();
          converged = converged && solver->solve(problem, state).converged;
          ++n_solutions;
      } while (friction && !friction->agrees(problem, state));
      if (friction)
        {
          converged = converged && !friction->failed();
          friction->end_step();
        }
      time += h;
      return motion.end_step(nodal_forces(problem, state));
    }

    ReducedMotion  motion;
    ContactProblem problem;
    ContactState   state;
    double         h, time = 0.;
    bool           converged = true;

    std::optional<PatchFriction> friction;
    unsigned int                 n_solutions = 0;

  private:
    static std::vector<double> amplitudes(const ReducedPair         &pair,
                                          const std::vector<double> &forces)
    {
      DenseMatrix         K = pair.K_m;
      std::vector<double> x = transposed_product(pair.Phi, forces);
      solve_general(K, as_vector(x));
      return x;
    }

    std::unique_ptr<ContactSolver> solver;
    std::vector<double>            gap;
  };
} // namespace StabilityBodies

#endif
