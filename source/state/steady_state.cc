#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/state/steady_state.h>

namespace RollingContact
{
  StateDemands demands_in_time(const PairDemands &pair)
  {
    StateDemands demands;
    demands.pair                  = pair;
    demands.pair.surfaces_in_time = true;
    demands.zone                  = 1.5;
    demands.margin                = 3.;
    demands.one_direction         = false;
    demands.rough_responses       = false;
    return demands;
  }

  ContactState initial_state(const ContactProblem &problem,
                             const PatchEstimate  &patch)
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

  template <int dim>
  ContactState transferred_state(const SteadyState<dim> &previous,
                                 const ContactProblem   &problem)
  {
    const ContactState &old   = previous.state;
    ContactState        state = open_state(problem);
    state.approach            = old.approach;
    for (unsigned int i = 0; i < problem.n_nodes(); ++i)
      if (const auto weights = previous.pair->trace().interpolation(
            problem.operators.positions()[i][0],
            problem.operators.positions()[i][1]))
        {
          state.pressure[i] = apply(*weights, old.pressure);
          for (unsigned int c = 0; c < problem.n_tangential(); ++c)
            state.traction(c, i) = apply(*weights, old.traction, c);
        }
    return state;
  }

  std::string shortfall(const SolverReport &solver, const double tolerance)
  {
    return solver.reason + ". Natural residual " +
           scientific(solver.residual.worst(), 3) + ", required " +
           scientific(tolerance, 3);
  }

  template <int dim>
  void require_solved(const PairSpec         &scene,
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
  template struct SteadyState<3>;
  template ContactState transferred_state(const SteadyState<2> &,
                                          const ContactProblem &);
  template ContactState transferred_state(const SteadyState<3> &,
                                          const ContactProblem &);
  template void
  require_solved(const PairSpec &, const SteadyState<2> &, const std::string &);
  template void
  require_solved(const PairSpec &, const SteadyState<3> &, const std::string &);
} // namespace RollingContact
