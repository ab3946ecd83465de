#include <rolling_contact/solvers/extragradient.h>
#include <rolling_contact/solvers/newton_step.h>
#include <rolling_contact/solvers/semismooth_newton.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    /**
     * Add the part 1, 1/2, ..., 1/64 of a step to the traction, cut back to the
     * traction bound: the first that lowers the residual by a tenth of the
     * part, else the best of them. Tractions beyond the bound, which a full
     * step may have tenfold, would be where the step's linearisation does not
     * hold.
     */
    void take_damped_step(const TouchingFriction    &problem,
                          const std::vector<double> &step,
                          const double               residual_now,
                          std::vector<double>       &traction)
    {
      const std::vector<double> start = traction;
      std::vector<double>       best_traction;
      double                    best = std::numeric_limits<double>::infinity();
      for (double part = 1.; part > 0.01; part /= 2)
        {
          for (std::size_t k = 0; k < traction.size(); ++k)
            traction[k] = start[k] + part * step[k];
          problem.project(traction);
          const double now = problem.residual(traction);
          if (now < (1 - 0.1 * part) * residual_now)
            return;
          if (best_traction.empty() || now < best)
            {
              best          = now;
              best_traction = traction;
            }
        }
      traction = best_traction;
    }

    /**
     * The traction on the way down, and the best so far.
     */
    class Descent
    {
    public:
      explicit Descent(std::vector<double> start)
        : q(std::move(start))
        , best_q(q)
      {}

      /**
       * The residual of q.
       */
      void note(const double residual)
      {
        const bool lower = residual < best;
        n_stalled        = lower ? 0 : n_stalled + 1;
        if (!lower)
          return;
        best   = residual;
        best_q = q;
      }

      /**
       * Go on from another traction, whatever its residual.
       */
      void restart(std::vector<double> other)
      {
        q         = std::move(other);
        n_stalled = 0;
        best      = std::numeric_limits<double>::infinity();
      }

      std::vector<double> q, best_q;
      unsigned int        n_stalled = 0;

    private:
      double best = std::numeric_limits<double>::infinity();
    };
  } // namespace

  SolverReport SemismoothNewton::solve(const TangentialProblem &problem,
                                       ContactState            &state) const
  {
    const unsigned int max_steps = 60, patience = 6, max_rescues = 4;
    const double       of_right_side = 1e-4; // left of a step by iterations
    SolverReport       report;
    report.solver = "active set";
    problem.project(state.traction);
    const TouchingFriction touching(problem);
    if (touching.unknowns.empty() || touching.norm == 0.)
      {
        report.converged = true;
        return report;
      }
    const double rho = controls.tangential_augmentation / touching.norm;
    Descent      way(touching.gathered(state.traction));
    // a slip too small for the tolerance still gets its traction
    const bool   from_rest = std::all_of(way.q.begin(),
                                       way.q.end(),
                                       [](const double x) { return x == 0.; });
    unsigned int n_rescues = 0;
    for (unsigned int k = 0; k <= max_steps; ++k)
      {
        const double now           = touching.residual(way.q);
        report.residual.tangential = now;
        report.history.push_back(report.residual);
        if (now <= 0.5 * controls.tolerance &&
            (k > 0 || !from_rest || now == 0.))
          {
            touching.scatter(way.q, state.traction);
            report.converged = true;
            return report;
          }
        way.note(now);
        if (n_rescues > max_rescues || (k == 0 && !std::isfinite(now)))
          break;
        if (way.n_stalled > patience || !std::isfinite(now))
          {
            const unsigned int n_steps = 20u << n_rescues++;
            touching.scatter(way.best_q, state.traction);
            report.iterations += rescue(problem, n_steps, state);
            way.restart(touching.gathered(state.traction));
            continue;
          }
        std::vector<double> step;
        if (!newton_step(touching, way.q, rho, of_right_side, step))
          break;
        take_damped_step(touching, step, now, way.q);
        ++report.iterations;
        ++report.tangential_solves;
      }
    touching.scatter(way.best_q, state.traction);
    report.reason = "the semismooth Newton iteration stopped falling";
    return report;
  }

  unsigned int SemismoothNewton::rescue(const TangentialProblem &problem,
                                        const unsigned int       n_steps,
                                        ContactState            &state) const
  {
    SolverControls few = controls;
    few.max_iterations = n_steps;
    return Extragradient(few).solve(problem, state).iterations;
  }
} // namespace RollingContact
