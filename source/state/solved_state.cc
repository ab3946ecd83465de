#include <rolling_contact/base/exceptions.h>
#include <rolling_contact/base/text.h>
#include <rolling_contact/state/solved_state.h>

namespace RollingContact
{
  std::string
  shortfall(const SolverReport &solver, const double tolerance)
  {
    return solver.reason + ". Natural residual " +
           scientific(solver.residual.worst(), 3) + ", required " +
           scientific(tolerance, 3);
  }



  template <int dim>
  void
  require_solved(const SceneParameters  &scene,
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



  template void
  require_solved(const SceneParameters &,
                 const SteadyState<2> &,
                 const std::string &);
  template void
  require_solved(const SceneParameters &,
                 const SteadyState<3> &,
                 const std::string &);
} // namespace RollingContact
