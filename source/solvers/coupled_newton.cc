#include <rolling_contact/base/interrupt.h>
#include <rolling_contact/base/memory.h>
#include <rolling_contact/solvers/coupled_newton.h>
#include <rolling_contact/solvers/newton_system.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace RollingContact
{
  namespace
  {
    NaturalResidual residual_of(const ContactProblem &problem,
                                const ContactState   &state)
    {
      return natural_residual(problem,
                              tangential_problem(problem, state),
                              state);
    }

    /**
     * The given part of the way from one state to another, without pulls.
     */
    ContactState
    between(const ContactState &from, const ContactState &to, const double part)
    {
      ContactState state = to;
      for (std::size_t i = 0; i < state.pressure.size(); ++i)
        state.pressure[i] = std::max(
          0., from.pressure[i] + part * (to.pressure[i] - from.pressure[i]));
      state.traction -= from.traction;
      state.traction *= part;
      state.traction += from.traction;
      state.approach = from.approach + part * (to.approach - from.approach);
      return state;
    }

    /**
     * Step by the part 1, 1/2, ..., 1/64: the first that lowers the residual by
     * a tenth of the part, else the best of them. Returns the new residual.
     */
    NaturalResidual take_damped_step(const ContactProblem  &problem,
                                     const ContactState    &target,
                                     const NaturalResidual &before,
                                     ContactState          &state)
    {
      const ContactState start = state;
      NaturalResidual    best{std::numeric_limits<double>::infinity(), 0.};
      for (double part = 1.; part > 0.01; part /= 2)
        {
          const ContactState    trial    = between(start, target, part);
          const NaturalResidual residual = residual_of(problem, trial);
          if (residual.worst() < best.worst() || part == 1.)
            {
              best  = residual;
              state = trial;
            }
          if (residual.worst() < (1 - 0.1 * part) * before.worst())
            break;
        }
      return best;
    }

    /**
     * Whether the matrix of a step fits the memory, and a second one while it
     * is made.
     */
    bool fits_memory(const ContactProblem &problem, const ContactState &state)
    {
      const double n = (problem.n_tangential() + 1.) *
                       std::count_if(state.pressure.begin(),
                                     state.pressure.end(),
                                     [](const double p) { return p > 0.; }),
                   bytes = 2 * sizeof(double) * n * n,
                   free  = available_memory();
      return free <= 0. || bytes <= 0.7 * free;
    }
  } // namespace

  SolverReport CoupledNewton::solve(const ContactProblem &problem,
                                    ContactState         &state) const
  {
    const unsigned int max_steps = 100, patience = 15;
    SolverReport       report;
    report.solver = "coupled Newton";
    complete(problem, state);
    report.residual = residual_of(problem, state);
    if (!fits_memory(problem, state))
      {
        report.reason = "Newton's matrix does not fit the memory";
        return report;
      }
    ContactState    best      = state;
    NaturalResidual lowest    = report.residual;
    unsigned int    n_stalled = 0;
    while (report.residual.worst() > controls.tolerance &&
           report.iterations < max_steps && n_stalled < patience)
      {
        throw_if_interrupted();
        ContactState target;
        if (!NewtonSystem(problem, controls, state).solve(target))
          break;
        report.residual =
          take_damped_step(problem, target, report.residual, state);
        report.history.push_back(report.residual);
        ++report.iterations;
        n_stalled =
          report.residual.worst() < 0.9 * lowest.worst() ? 0 : n_stalled + 1;
        if (report.residual.worst() < lowest.worst())
          {
            lowest = report.residual;
            best   = state;
          }
      }
    report.converged = report.residual.worst() <= controls.tolerance;
    if (!report.converged)
      {
        state           = best;
        report.residual = lowest;
        report.reason =
          "the Newton iteration for pressure and traction at once "
          "stopped falling";
      }
    report.normal_solves = report.tangential_solves = report.iterations;
    return report;
  }
} // namespace RollingContact
