#include <rolling_contact/base/text.h>
#include <rolling_contact/report/state_summary.h>
#include <rolling_contact/run/log.h>

#include <cmath>

namespace RollingContact
{
  std::string
  work_of_solver(const SolverReport &solver)
  {
    std::string text =
      solver.solver + ", " + std::to_string(solver.normal_solves) +
      " normal and " + std::to_string(solver.tangential_solves) +
      " tangential solves in " + std::to_string(solver.passes) + " passes";
    if (solver.corrections > 0)
      text += ", " + std::to_string(solver.corrections) +
              (solver.corrections == 1 ? " correction" : " corrections") +
              " of the compliance";
    if (solver.friction_rounds > 0)
      text += ", friction law in " + std::to_string(solver.friction_rounds) +
              " rounds";
    return text + "; natural residual " +
           scientific(solver.residual.normal, 2) + " normal, " +
           scientific(solver.residual.tangential, 2) + " tangential";
  }



  namespace
  {
    std::string
    millimetres(const double length)
    {
      return significant(1e3 * length, 5) + " mm";
    }
  } // namespace



  template <int dim>
  void
  note_state(const SceneParameters  &scene,
             const SteadyState<dim> &steady,
             RunReport              &report)
  {
    const Resultants &result = steady.result;
    if (result.n_touching == 0)
      {
        report.set_finding("load",
                           "N = 0 at an approach of " +
                             millimetres(steady.state.approach) +
                             ": the bodies do not touch");
        return;
      }
    report.set_finding(
      "load",
      "N = " + significant(result.normal_force, 6) + " N at an approach of " +
        millimetres(steady.state.approach) + "; peak pressure " +
        significant(1e-6 * result.max_pressure, 5) + " MPa, half-width " +
        millimetres(result.half_width_x) + ", " +
        std::to_string(result.n_touching) + " nodes touch");
    if (result.friction_force <= 0.)
      return;
    const std::string across =
      dim == 2 ? "" : ", " + significant(result.force_y, 6);
    report.set_finding(
      "force",
      (dim == 2 ? "T = " : "T = (") + significant(result.force_x, 6) + across +
        (dim == 2 ? " N" : ") N") +
        ", |T|/N = " + significant(result.traction_coefficient, 5) +
        (steady.problem.friction_law
           ? ""
           : ", |T|/(mu N) = " +
               significant(std::hypot(result.force_x, result.force_y) /
                             result.friction_force,
                           5)) +
        "; stick on " +
        significant(100 * result.stick_area / result.contact_area, 3) +
        " % of the patch");
  }



  void
  warn_of_few_nodes(const unsigned int n_touching, Log &log)
  {
    if (n_touching < 5)
      log.warning("Only " + std::to_string(n_touching) +
                  " nodes touch: the patch is unresolved, take more elements "
                  "(Mesh/Elements across patch).");
  }



  template void
  note_state(const SceneParameters &, const SteadyState<2> &, RunReport &);
  template void
  note_state(const SceneParameters &, const SteadyState<3> &, RunReport &);
} // namespace RollingContact
